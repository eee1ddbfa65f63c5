// Who speaks Portuguese is shown the Portuguese page, unless they have just chosen English.
'use strict';

// index.html?app=frame&model=... is the page of that app.
const asked = new URLSearchParams(location.search).get('app');
if (['frame', 'plane', 'cross', 'mohr', 'euler'].includes(asked))
    location.replace(asked + '.html' + location.search + location.hash);

const hasChosen = new URLSearchParams(location.search).has('lang');
if (document.documentElement.lang === 'en' && navigator.language.startsWith('pt') && !hasChosen)
    location.replace('index.pt_BR.html');
