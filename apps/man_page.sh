#!/bin/sh
# Writes a manual page from what the program says of itself: man_page.sh PROGRAM SUMMARY
# Every subcommand that its help lists gets a section of its own.
set -eu
program=$1
name=$(basename "$program")
"$program" --help >/dev/null # fails here rather than inside a pipe
version=$("$program" --version | awk '{ print $2; exit }')

# Plain help to roff: titles that end with ":", items indented by two with their text behind or below, paragraphs.
roff() {
    awk -v name="$name" '
        { gsub(/\\/, "\\e"); gsub(/-/, "\\-") }
        /^$/                    { if (!blank) print ".PP"; blank = 1; item = 0; next }
                                { blank = 0 }
        /^[A-Z][A-Za-z ]*:$/    { sub(/:$/, ""); print (top ? ".SH " : ".SS ") toupper(substr($0, 1, 1)) substr($0, 2); blank = 1; next }
        /^(Usage|Uso):/         { sub(/^[^:]*: *[^ ]*/, name); print ".PP\n\\fB" $0 "\\fR"; next }
        /^  [^ ]/               { sub(/^  /, ""); text = ""
                                  if (match($0, /  +/)) { text = substr($0, RSTART + RLENGTH); $0 = substr($0, 1, RSTART - 1) }
                                  sub(/ +$/, ""); print ".TP\n\\fB" $0 "\\fR"; if (text != "") print guarded(text); item = 1; next }
                                { sub(/^ +/, ""); print guarded($0) }
        function guarded(line)  { return line ~ /^[.\x27]/ ? "\\&" line : line }
    '
}

commands=$("$program" --help | awk '/^Commands:/ { inside = 1; next } /^[^ ]/ { inside = 0 } inside && NF { print $1 }')

printf '.TH %s 1 "" "Cremona %s" "Cremona"\n' "$(printf %s "$name" | tr '[:lower:]' '[:upper:]')" "$version"
printf '.SH NAME\n%s \\- %s\n.SH DESCRIPTION\n' "$name" "$2"
"$program" --help | roff
for command in $commands; do
    printf '.SH %s\n' "$(printf %s "$name $command" | tr '[:lower:]' '[:upper:]')"
    "$program" "$command" --help | awk '/^Exit status:/ { exit } { print }' | roff
done
