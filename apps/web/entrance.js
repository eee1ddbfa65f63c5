// Who speaks Portuguese is shown the Portuguese page, unless they have just chosen English.
'use strict';

if (document.documentElement.lang === 'en' && navigator.language.startsWith('pt') && !new URLSearchParams(location.search).has('lang'))
    location.replace('index.pt_BR.html');
