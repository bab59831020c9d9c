"""Single operations on balls with python-flint."""

from flint import arb, ctx

from . import run
from .numbers import rational, written

OPERATIONS = {
    "add": lambda a, b: (a + b,),
    "mul": lambda a, b: (a * b,),
    "div": lambda a, b: (a / b,),
    "sqrt": lambda a, b: (a.sqrt(),),
    "sin+cos": lambda a, b: a.sin_cos(),
    "atan": lambda a, b: (a.atan(),),
}


def main():
    row, lines, answers = run.arguments()
    ctx.prec = int(row.partition("-")[2])
    operands = [tuple(arb(rational(word)) for word in line) for line in lines]
    for task, operation in OPERATIONS.items():
        run.say(task, run.quickest(lambda: [operation(a, b) for a, b in operands]) / len(operands))
        for a, b in operands if answers else ():
            run.answer(task, [written(x) for x in operation(a, b)])


if __name__ == "__main__":
    main()
