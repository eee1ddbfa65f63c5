"""core_test.py CORE CREMONA: cremona.js under node answers as the program cremona does, for every example and case of members."""

import json
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE, CREMONA = map(pathlib.Path, (sys.argv.pop(1), sys.argv.pop(1)))
RELATIVE = 1e-9  # of the largest value of its kind in a case

ASK = '''
import { readFileSync } from 'node:fs';
const { solve, check, verify, ModelError } = await import(process.argv[1]);
const answers = process.argv.slice(2).map((file) => {
    const model = readFileSync(file, 'utf8');
    const answer = { faults: check(model) };
    try {
        answer.solved = solve(model);
        answer.verified = verify(JSON.parse(model));
    } catch (error) {
        if (!(error instanceof ModelError)) throw error;
        answer.refused = error.faults;
    }
    return answer;
});
console.log(JSON.stringify(answers));
'''


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


class Core(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.models = models()
        module = (CORE / 'cremona.js').resolve().as_uri()
        done = subprocess.run(['node', '--no-experimental-fetch', '--input-type=module', '-e', ASK, '--', module,
                               *map(str, cls.models)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        cls.answers = dict(zip(cls.models, json.loads(done.stdout)))

    def test_results_are_those_of_the_program(self):
        self.assertGreater(len(self.models), 20)
        for path in self.models:
            with self.subTest(model=path.name):
                status, out, _ = native('solve', path, '--json')
                answer = self.answers[path]
                if status == 0:
                    self.assertEqual(differences(answer['solved'], json.loads(out)), [])
                else:
                    self.assertTrue(answer['refused'])

    def test_what_is_wrong_is_told_as_the_program_tells_it(self):
        for path in self.models:
            with self.subTest(model=path.name):
                _, _, err = native('check', path)
                for fault in self.answers[path]['faults']:
                    self.assertIn(fault['message'], err)

    def test_what_a_model_expects_is_verified(self):
        n_passed = 0
        for path in self.models:
            answer = self.answers[path]
            if 'verified' not in answer:
                continue
            with self.subTest(model=path.name):
                self.assertEqual(answer['verified']['failed'], 0)
                n_passed += answer['verified']['passed']
        self.assertGreater(n_passed, 100)

    def test_what_cannot_stand_is_refused_in_words(self):
        refused = self.answers[ROOT / 'examples/mechanism.json']['refused']
        self.assertIn('can move', refused[0]['message'])


if __name__ == '__main__':
    unittest.main(verbosity=2)
