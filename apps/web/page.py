"""A page of the site that is read, around what stands in it."""

import html

# Nothing but the page's own files: what is written in a document never runs.
POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
          "manifest-src 'self'; worker-src 'self'")


def page(title, body, *, top='', language='en', heading='', footing='', head=''):
    """`top`: the way to the site's folder, as in '../'. `body`, `heading`, `footing`, `head`: HTML; `title` is text."""
    return f'''<!DOCTYPE html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<link rel="icon" href="data:,">
<link rel="manifest" href="{top}manifest.webmanifest">
<link rel="stylesheet" href="{top}site.css">
<title>{html.escape(title, quote=False)}</title>
{head}<script src="{top}offline.js" defer></script>
</head>
<body>
<header>
{heading}</header>
<main>
{body}</main>
<footer>
{footing}</footer>
</body>
</html>
'''
