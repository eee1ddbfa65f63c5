#!/bin/sh
# Writes the completion of bash for a program from what it says of itself: completion.sh PROGRAM
# Its commands, the options of each, and files.
set -eu
program=$1
name=$(basename "$program")
"$program" --help >/dev/null # fails here rather than inside a pipe

# The options that a help names, in one line.
options() { awk '/^  -/ { for (i = 1; i <= NF && $i ~ /^-/; ++i) { sub(/,$/, "", $i); printf "%s ", $i } }'; }

commands=$("$program" --help | awk '/^Commands:/ { inside = 1; next } /^[^ ]/ { inside = 0 } inside && NF { printf "%s ", $1 }')
function=_$(printf %s "$name" | tr - _)

printf '# Completion of %s for bash.\n%s() {\n    local words\n' "$name" "$function"
# shellcheck disable=SC2016 # of the completion's own variables
if [ -n "$commands" ]; then
    printf '    case ${COMP_WORDS[1]-} in\n'
    for command in $commands; do
        printf "    %s) words='%s' ;;\n" "$command" "$("$program" "$command" --help | options)"
    done
    printf "    *) words='%s' ;;\n    esac\n" "$("$program" --help | options)"
    printf "    [ \"\$COMP_CWORD\" -ne 1 ] || words=\"%sframe plane \$words\"\n" "$commands"
else
    printf "    words='%s'\n" "$("$program" --help | options)"
fi
# shellcheck disable=SC2016
printf '    mapfile -t COMPREPLY < <(compgen -W "$words" -- "${COMP_WORDS[COMP_CWORD]}")\n}\n'
printf 'complete -o default -F %s %s\n' "$function" "$name"
