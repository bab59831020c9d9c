#!/bin/sh
# burmester itself in double precision: the positions rounded to floats, nothing certified.
# Every answer is wrapped as the protocol wants it.
"${BURMESTER:-burmester}" solve --lines --arithmetic f64 |
    while IFS= read -r answer; do
        printf '{"result":%s}\n' "$answer"
    done
