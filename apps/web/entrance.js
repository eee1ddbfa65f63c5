// Who speaks Portuguese is shown the Portuguese page, unless they have just chosen English.
'use strict';

const hasChosen = new URLSearchParams(location.search).has('lang');
if (document.documentElement.lang === 'en' && navigator.language.startsWith('pt') && !hasChosen)
    location.replace('index.pt_BR.html');
