# Shared by ./web: sources that Debian ships as source packages alone, outside the tree.
# shellcheck shell=bash
sources="${XDG_CACHE_HOME:-$HOME/.cache}/cremona/sources"

# apt_of_sources ARGS...: apt-get with lists of its own: this machine's Debian archives, for source packages.
apt_of_sources() {
    apt-get -q -o Dir::Etc::sourcelist="$sources/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
        -o Dir::State::lists="$sources/apt/lists" -o Dir::Cache="$sources/apt/cache" \
        -o APT::Sandbox::User=root "$@"
}

list_archives() {
    mkdir -p "$sources/apt/lists/partial" "$sources/apt/cache/archives/partial"
    # shellcheck disable=SC2016 # the names are apt's, not the shell's
    apt-get indextargets --format 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $(REPO_URI) $(RELEASE) $(COMPONENT)' \
        'Created-By: Packages' 'Origin: Debian' | sort -u >"$sources/apt/sources.list"
}

# unpack_source PACKAGE VERSION: apt holds it against the signed lists. Prints where it lies: $sources/PACKAGE-VERSION.
unpack_source() {
    local folder="$sources/$1-$2"
    if [ ! -d "$folder" ]; then
        say "Fetching the source of $1 $2"
        list_archives
        apt_of_sources update && (cd "$sources/apt" && apt_of_sources source --download-only "$1=$2") &&
            dpkg-source --no-copy -x "$sources/apt/$1_${2#*:}.dsc" "$folder.part" && mv "$folder.part" "$folder"
    fi >&2 || return 1
    printf '%s\n' "$folder"
}
