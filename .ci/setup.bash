# Shared by ./run, ./test and .ci/run: installs what is missing and builds. Everything it says goes to stderr, so that
# what a program prints can be piped.
# shellcheck shell=bash disable=SC2154 # root is set by the caller

say() { printf '%s\n' "$*" >&2; }

fail() {
    say "$(basename "$0"): $*"
    exit 2
}

# wanted_packages PART...: the lines of these parts of packages.txt ("a | b": either will do).
wanted_packages() {
    awk -v parts=" $* " '
        /^[[:space:]]*(#|$)/ { next }
        /^\[/                { gsub(/[][[:space:]]/, ""); wanted = index(parts, " " $0 " "); next }
        wanted               { print }' "$root/packages.txt"
}

is_installed() { [[ "$installed" == *$'\n'"$1"$'\n'* ]]; }
is_available() { apt-cache show "$1" >/dev/null 2>&1; }

# missing_packages PART...: of each line of which nothing is installed, the alternatives.
missing_packages() {
    local installed line name
    installed=$'\n'$(dpkg-query -W -f '${db:Status-Status} ${binary:Package}\n' 2>/dev/null |
        sed -n 's/^installed \([^:]*\).*/\1/p')$'\n'
    wanted_packages "$@" | while IFS= read -r line; do
        for name in ${line//|/ }; do
            is_installed "$name" && continue 2
        done
        printf '%s\n' "$line"
    done
}

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "needs root to install packages and there is no sudo; as root, run: $*"
    fi
}

# choose_packages: of each line of alternatives on stdin, the first that this system offers.
choose_packages() {
    local line name
    while IFS= read -r line; do
        for name in ${line//|/ }; do
            is_available "$name" && break
        done
        printf '%s\n' "$name"
    done
}

# install_packages PART...: installs what is missing of these parts; silent when nothing is.
install_packages() {
    command -v apt-get >/dev/null || return 0 # elsewhere CMake finds or fetches what is needed
    local missing names
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0
    say "Installing from Debian: ${missing//$'\n'/, }"
    quietly "$root/build/packages.log" as_root apt-get update -qq ||
        say "the package lists could not be refreshed; going on with the old ones"
    names=$(choose_packages <<<"$missing")
    # shellcheck disable=SC2086 # one word a package
    quietly "$root/build/packages.log" \
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $names ||
        fail "could not install: ${names//$'\n'/ }"
}

# quietly LOG COMMAND...: runs it, and shows what it said only if it fails.
quietly() {
    local log=$1
    shift
    mkdir -p "$(dirname "$log")"
    if ! "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        return 1
    fi
}

# configure PRESET [-DNAME=VALUE...]: unless that is how the build folder is configured already.
configure() {
    local preset=$1 cache="$root/build/$1/CMakeCache.txt" setting
    shift
    if [ -e "$root/build/$preset/build.ninja" ]; then
        for setting in "$@"; do
            setting=${setting#-D}
            grep -q "^${setting%%=*}:[A-Z]*=${setting#*=}\$" "$cache" || break
            setting=
        done
        [ -n "${setting-}" ] || return 0
    fi
    say "Configuring build/$preset"
    (cd "$root" && quietly "build/$preset.log" cmake --preset "$preset" "$@") ||
        fail "configuring failed; its words are above and in build/$preset.log"
}

# build PRESET TARGET...: silent when there is nothing to do.
build() {
    local folder="$root/build/$1"
    shift
    ninja -C "$folder" -n "$@" 2>/dev/null | grep -q 'ninja: no work to do' && return 0
    say "Building in ${folder#"$root/"} (the first time takes some minutes)"
    if [ -t 2 ]; then
        ninja -C "$folder" "$@" >&2
    else
        ninja -C "$folder" --quiet "$@" >&2
    fi || fail "the build failed; its words are above"
}
