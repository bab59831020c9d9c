"""Problems of `data/problems` beside their answers of `data/answers`."""

import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def lines(path):
    with open(path) as file:
        return [json.loads(line) for line in file]


def cases(kind):
    """(problem, answer) of every corpus, joined by id."""
    for path in sorted((ROOT / "data/problems").glob("*.jsonl")):
        problems = [p for p in lines(path) if p["problem"] == kind]
        if problems:
            answers = {a["id"]: a["answer"] for a in lines(ROOT / "data/answers" / path.name)}
            for problem in problems:
                yield problem, answers[problem["id"]]
