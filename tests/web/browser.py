"""Chromium without a screen, driven over the pipe of its DevTools: of Python the standard library alone."""

import base64
import json
import os
import select
import subprocess
import tempfile
import time


KEY_NUMBERS = {'Backspace': 8, 'Tab': 9, 'Enter': 13, 'Escape': 27, 'PageUp': 33, 'PageDown': 34, 'End': 35, 'Home': 36,
               'ArrowLeft': 37, 'ArrowUp': 38, 'ArrowRight': 39, 'ArrowDown': 40, 'Delete': 46,
               **{f'F{n}': 111 + n for n in range(1, 13)}}  # without them Chromium waits for ever


class Browser:
    """One page of a browser whose profile begins empty, unless it is given one."""

    def __init__(self, width=1280, height=800, profile=None, scale=1, language='en-US'):
        self.profile = profile or tempfile.mkdtemp(prefix='cremona-browser-')
        to_browser, self.requests = os.pipe()
        self.answers, from_browser = os.pipe()

        def as_descriptors_3_and_4():
            copies = os.dup(to_browser), os.dup(from_browser)
            os.dup2(copies[0], 3)
            os.dup2(copies[1], 4)

        self.process = subprocess.Popen(
            ['chromium', '--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
             '--enable-unsafe-swiftshader', '--no-first-run', '--disable-extensions', '--remote-debugging-pipe',
             f'--user-data-dir={self.profile}', f'--window-size={width},{height}',
             f'--force-device-scale-factor={scale}', f'--accept-lang={language}', 'about:blank'],
            preexec_fn=as_descriptors_3_and_4, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.number, self.heard, self.events, self.session = 0, b'', [], None
        self.downloads = tempfile.mkdtemp(prefix='cremona-downloads-')
        self.call('Browser.setDownloadBehavior', behavior='allow', downloadPath=self.downloads)
        self.call('Browser.grantPermissions', permissions=['clipboardReadWrite', 'clipboardSanitizedWrite'])
        target = next(t for t in self.call('Target.getTargets')['targetInfos'] if t['type'] == 'page')
        self.session = self.call('Target.attachToTarget', targetId=target['targetId'], flatten=True)['sessionId']
        for domain in ('Page', 'Runtime', 'Log', 'Network'):
            self.call(domain + '.enable')
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=scale, mobile=False)
        self.call('Emulation.setFocusEmulationEnabled', enabled=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.session = None
            self.call('Browser.close')
        except (OSError, TimeoutError):
            self.process.kill()
        self.process.wait(20)

    def message(self, patience):
        end = time.monotonic() + patience
        while b'\0' not in self.heard:
            if not select.select([self.answers], [], [], max(0.0, end - time.monotonic()))[0]:
                return None
            self.heard += os.read(self.answers, 1 << 20)
        text, self.heard = self.heard.split(b'\0', 1)
        return json.loads(text)

    def call(self, method, patience=60, **parameters):
        self.number += 1
        request = {'id': self.number, 'method': method, 'params': parameters}
        if self.session:
            request['sessionId'] = self.session
        os.write(self.requests, json.dumps(request).encode() + b'\0')
        end = time.monotonic() + patience
        while time.monotonic() < end:
            answer = self.message(end - time.monotonic())
            if answer is None:
                break
            if answer.get('id') == self.number:
                if 'error' in answer:
                    raise RuntimeError(f'{method}: {answer["error"]}')
                return answer['result']
            self.events.append(answer)
        raise TimeoutError(method)

    def wait(self, seconds):
        """Lets the page go on."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            event = self.message(end - time.monotonic())
            if event:
                self.events.append(event)

    def value(self, expression):
        result = self.call('Runtime.evaluate', expression=expression, awaitPromise=True, returnByValue=True)
        if 'exceptionDetails' in result:
            raise RuntimeError(f'{expression}: {result["exceptionDetails"]}')
        return result['result'].get('value')

    def wait_for(self, expression, patience=60):
        end = time.monotonic() + patience
        while not self.value(expression):
            if time.monotonic() > end:
                raise TimeoutError(expression)
            self.wait(0.05)

    def read(self, address):
        """Opens a page that is read."""
        self.call('Page.navigate', url=address)
        self.wait_for("document.readyState === 'complete' && location.href !== 'about:blank'")

    def open(self, address):
        """Opens the page of an app, and waits until the app draws. Returns how long that took [s]."""
        begin = time.monotonic()
        self.call('Page.navigate', url=address)
        self.wait_for("document.title.includes('\u2013')")
        took = time.monotonic() - begin
        self.wait(0.5)
        return took

    def move(self, x, y, buttons=0):
        self.call('Input.dispatchMouseEvent', type='mouseMoved', x=x, y=y, buttons=buttons)
        self.wait(0.05)

    def press(self, x, y, button='left', count=1):
        self.call('Input.dispatchMouseEvent', type='mousePressed', x=x, y=y, button=button, clickCount=count,
                  buttons=1 if button == 'left' else 2)
        self.wait(0.05)

    def release(self, x, y, button='left', count=1):
        self.call('Input.dispatchMouseEvent', type='mouseReleased', x=x, y=y, button=button, clickCount=count)
        self.wait(0.05)

    def click(self, x, y, button='left'):
        self.move(x, y)
        self.press(x, y, button)
        self.release(x, y, button)
        self.wait(0.15)

    def touch(self, kind, *places):
        """Start, Move or End: the fingers that are down then."""
        self.call('Input.dispatchTouchEvent', type='touch' + kind, touchPoints=[{'x': x, 'y': y} for x, y in places])
        self.wait(0.1)

    def tap(self, x, y):
        self.touch('Start', (x, y))
        self.touch('End')
        self.wait(0.15)

    def key(self, name, code=None, ctrl=False, shift=False, text=None):
        """A stroke: 'Escape', or a letter. `text`: what it writes, unless it is held with Ctrl."""
        if text is None and len(name) == 1 and not ctrl:
            text = name
        parameters = {'key': name, 'code': code or name, 'modifiers': (2 if ctrl else 0) + (8 if shift else 0),
                      'windowsVirtualKeyCode': ord(name.upper()) if len(name) == 1 else KEY_NUMBERS[name]}
        self.call('Input.dispatchKeyEvent', type='keyDown', **({'text': text} if text else {}), **parameters)
        self.wait(0.05)
        self.call('Input.dispatchKeyEvent', type='keyUp', **parameters)
        self.wait(0.1)

    def type(self, text):
        for letter in text:
            self.key(letter)

    def picture(self, path):
        data = self.call('Page.captureScreenshot', format='png')['data']
        with open(path, 'wb') as file:
            file.write(base64.b64decode(data))

    def complaints(self):
        """What the page wrote to its console, and exceptions."""
        texts = []
        for event in self.events:
            method, parameters = event.get('method'), event.get('params', {})
            if method == 'Runtime.exceptionThrown':
                details = parameters['exceptionDetails']
                texts.append('exception: ' + details.get('exception', {}).get('description', details['text']))
            elif method == 'Runtime.consoleAPICalled':
                texts.append(parameters['type'] + ': ' + ' '.join(str(a.get('value', a.get('description')))
                                                                  for a in parameters['args']))
            elif method == 'Log.entryAdded':
                texts.append('log: ' + parameters['entry']['text'])
        return texts

    def requests_made(self):
        return [event['params']['request']['url'] for event in self.events
                if event.get('method') == 'Network.requestWillBeSent']
