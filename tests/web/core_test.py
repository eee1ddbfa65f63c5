"""core_test.py CORE CREMONA: cremona.js and cremona_all.js under node answer as the program cremona does, for every example and
every case of members, and for what is worked out by hand."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE, CREMONA = map(pathlib.Path, (sys.argv.pop(1), sys.argv.pop(1)))
RELATIVE = 1e-9  # of the largest value of its kind in a case

ASK = '''
import { readFileSync } from 'node:fs';
const { ModelError, ...core } = await import(process.argv[1]);
const answers = JSON.parse(readFileSync(0, 'utf8')).map((questions) => questions.map(([name, ...details]) => {
    try {
        return { value: core[name](...details) };
    } catch (error) {
        if (!(error instanceof ModelError)) throw error;
        return { refused: error.faults };
    }
}));
console.log(JSON.stringify(answers));
'''


def answers(module, questions):
    """Of each list of questions the list of answers; a question is [NAME, DETAIL...]."""
    address = (CORE / module).resolve().as_uri()
    done = subprocess.run(['node', '--no-experimental-fetch', '--input-type=module', '-e', ASK, '--', address],
                          input=json.dumps(questions), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def of_members(path):
    return 'curves' not in (model := json.loads(path.read_text(encoding='utf-8'))) and 'mesh' not in model


def models():
    files = sorted(ROOT.glob('examples/*.json')) + sorted(ROOT.glob('tests/cases/members/*.json'))
    return [path for path in files if of_members(path)]


def native(*arguments):
    done = subprocess.run([CREMONA, *arguments], capture_output=True, text=True, cwd=ROOT, check=False)
    return done.returncode, done.stdout, done.stderr


FORCES = ('N', 'V', 'Vy', 'Vz', 'fx', 'fy', 'fz')


def numbers(tree, kind=''):
    """Every number with what it is: the name nearest above it, of any force 'force'. Where a diagram has an extreme, its place
    comes with the extreme's own kind and value: one that is nothing but rounding lies anywhere."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            if key == 'at' and 'value' in tree:
                continue  # an extreme may be reached at several places
            if key == 'x' and 'value' in tree:
                yield 'place', (value, *next(numbers(tree['value'], kind)))
            else:
                inner = kind if isinstance(value, dict) or key == 'value' else 'force' if key in FORCES else key
                yield from numbers(value, key if isinstance(value, dict) and key in (*FORCES, 'M') else inner)
    elif isinstance(tree, list):
        for value in tree:
            yield from numbers(value, kind)
    elif isinstance(tree, (int, float)) and not isinstance(tree, bool):
        yield 'force' if kind in FORCES else kind, float(tree)


def differences(one, other):
    ours, theirs = list(numbers(one)), list(numbers(other))
    if [kind for kind, _ in ours] != [kind for kind, _ in theirs]:
        return ['other numbers']
    largest = {}
    for kind, value in theirs:
        if kind != 'place':
            largest[kind] = max(largest.get(kind, 0.0), abs(value))
    different = []
    for (kind, a), (_, b) in zip(ours, theirs):
        if kind == 'place':
            is_same = abs(a[0] - b[0]) <= RELATIVE * max(largest['x'], 1.0) or abs(b[2]) <= RELATIVE * largest[b[1]]
        else:
            is_same = kind == 'residual' or abs(a - b) <= RELATIVE * largest[kind]
        if not is_same:
            different.append((kind, a, b))
    return different


def text(path):
    return path.read_text(encoding='utf-8')


class Members(unittest.TestCase):
    """Of the small module, and of the whole one."""

    @classmethod
    def setUpClass(cls):
        cls.models = models()
        questions = [[['check', text(path)], ['solve', text(path)], ['verify', json.loads(text(path))]] for path in cls.models]
        cls.small = dict(zip(cls.models, answers('cremona.js', [asked[:2] for asked in questions])))
        cls.whole = dict(zip(cls.models, answers('cremona_all.js', questions)))

    def test_results_are_those_of_the_program(self):
        self.assertGreater(len(self.models), 20)
        for path in self.models:
            with self.subTest(model=path.name):
                status, out, _ = native('solve', path, '--json')
                for answer in self.small[path][1], self.whole[path][1]:
                    if status == 0:
                        self.assertEqual(differences(answer['value'], json.loads(out)), [])
                    else:
                        self.assertTrue(answer['refused'])

    def test_what_is_wrong_is_told_as_the_program_tells_it(self):
        for path in self.models:
            with self.subTest(model=path.name):
                _, _, err = native('check', path)
                self.assertEqual(self.small[path][0], self.whole[path][0])
                for fault in self.small[path][0]['value']:
                    self.assertIn(fault['message'], err)

    def test_what_a_model_expects_is_verified(self):
        n_passed = 0
        for path in self.models:
            verified = self.whole[path][2].get('value')
            if verified is None:
                continue
            with self.subTest(model=path.name):
                self.assertEqual(verified['failed'], 0)
                n_passed += verified['passed']
        self.assertGreater(n_passed, 100)

    def test_what_cannot_stand_is_refused_in_words(self):
        refused = self.small[ROOT / 'examples/mechanism.json'][1]['refused']
        self.assertIn('can move', refused[0]['message'])


def strings(svg):
    """What stands in a picture, and where to the pixel."""
    found = re.findall(r'<text[^>]*>.*?</text>', svg, re.DOTALL)
    return [(re.sub(r'<[^>]*>', '', one), [round(float(n)) for n in re.findall(r'\b[xy]="([-\d.]+)"', one)]) for one in found]


class Whole(unittest.TestCase):
    """What cremona_all.js has beside the small module."""

    def compare(self, asked, *arguments, given=None):
        answer = answers('cremona_all.js', [[asked]])[0][0]
        done = subprocess.run([CREMONA, *arguments], input=given, capture_output=True, text=True, cwd=ROOT, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('value', answer)
        self.assertEqual(differences(answer['value'], json.loads(done.stdout)), [])

    def test_plane_models_are_solved_and_verified(self):
        files = [path for path in sorted(ROOT.glob('examples/*.json')) if not of_members(path)]
        self.assertGreater(len(files), 4)
        asked = [[['check', text(path)], ['solve', text(path)], ['verify', text(path)]] for path in files]
        for path, (faults, solved, verified) in zip(files, answers('cremona_all.js', asked)):
            with self.subTest(model=path.name):
                _, out, _ = native('solve', path, '--json')
                self.assertEqual(differences(solved['value'], json.loads(out)), [])
                self.assertEqual([fault for fault in faults['value'] if fault['severity'] == 'error'], [])
                self.assertEqual(verified['value']['failed'], 0)

    def test_moments_are_distributed(self):
        for name in 'three_spans', 'portal_kleinlogel', 'portal':
            model = ROOT / f'examples/{name}.json'
            with self.subTest(model=name):
                self.compare(['cross', text(model)], 'cross', model, '--json')
        model = ROOT / 'examples/continuous_beam.json'
        self.compare(['cross', text(model), {'method': 'kani'}], 'cross', model, '--json', '--method', 'kani')

    def test_circles_are_those_of_the_program(self):
        self.compare(['mohr', {'stress': [50, -10, 40], 'angle': 30}], 'mohr', '--stress', '50,-10,40', '--angle', '30', '--json')
        self.compare(['mohr', {'stress': ['120 MPa', '-40 MPa', '60 MPa'], 'criterion': 'von_mises', 'strength': 'fy=250 MPa'}],
                     'mohr', '--stress', '120 MPa,-40 MPa,60 MPa', '--criterion', 'von_mises', '--strength', 'fy=250 MPa',
                     '--json')
        self.compare(['mohr', {'rosetteAngles': [0, 60, 120], 'rosetteReadings': ['60e-6', '135e-6', '264e-6'], 'E': '200 GPa',
                               'nu': 0.3}],
                     'mohr', '--rosette', '0,60,120:60e-6,135e-6,264e-6', '--E', '200 GPa', '--nu', '0.3', '--json')

    def test_scripts_of_operators_are_run(self):
        script = ROOT / 'examples/through_hole.eul'
        self.compare(['euler', text(script)], 'euler', script, '--json')

    def test_pictures_say_what_those_of_the_program_say(self):
        for name, details in (('portal', {'show': 'loads,M,labels'}), ('pratt_truss', {}), ('mechanism', {}),
                              ('storey_frame', {'show': 'V,labels', 'theme': 'dark', 'width': 1600, 'height': 900}),
                              ('dam', {'show': 'loads,labels,bands:mises'}), ('plate', {})):
            model = ROOT / f'examples/{name}.json'
            options = [f'--{key}={value}' for key, value in details.items() if key not in ('width', 'height')]
            if 'width' in details:
                options.append(f'--size={details["width"]}x{details["height"]}')
            with self.subTest(model=name), tempfile.TemporaryDirectory() as folder:
                native('render', model, '-o', f'{folder}/picture.svg', *options)
                wanted = strings(text(pathlib.Path(folder) / 'picture.svg'))
                found = strings(answers('cremona_all.js', [[['render', text(model), details]]])[0][0]['value'])
                self.assertGreater(len(wanted), 2)
                self.assertEqual([word for word, _ in found], [word for word, _ in wanted])
                far = [(a, b) for a, b in zip(found, wanted) if max(abs(x - y) for x, y in zip(a[1], b[1])) > 1]
                self.assertEqual(far, [])

    def test_what_is_asked_wrongly_is_refused_in_words(self):
        portal = text(ROOT / 'examples/portal.json')
        wrong = [['render', portal, {'show': 'luck'}], ['render', portal, {'colour': 'red'}], ['cross', portal, {'case': 'X'}],
                 ['mohr', {'stress': [1, 2]}], ['euler', 'mvfs s1 f1 v1 0 0 0\nmef s1'], ['solve', '{'], ['render', '{', {}]]
        for asked, (answer,) in zip(wrong, answers('cremona_all.js', [[one] for one in wrong])):
            with self.subTest(asked=asked[0]):
                self.assertTrue(answer['refused'][0]['message'])


if __name__ == '__main__':
    unittest.main(verbosity=2)
