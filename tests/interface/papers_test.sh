#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# papers_test.sh BUILD: manual pages, completions and the reference page of the command line.
set -euo pipefail
papers=$1/papers program=$1/ashimpact
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
# shellcheck source=tests/leave_out.sh
source "$here/../leave_out.sh"

fail() { echo "failed: $1"; exit 1; }
expect() { [[ $1 == *"$2"* ]] || fail "$3: '$2' is not in: $1"; }

mapfile -t commands < <("$program" --help | sed -n '/^Subcommands:/,$s/^  \([a-z-]\+\) .*/\1/p')
((${#commands[@]} >= 10)) || fail "commands: ${commands[*]}"

for tool in man col; do
    command -v "$tool" >/dev/null || leave_out "there is no '$tool' (./dev deps library)"
done

echo '== manual pages'
for command in '' "${commands[@]/#/-}"; do
    page=$papers/man/ashimpact$command.1
    LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>"$scratch/warnings" >/dev/null
    [[ ! -s $scratch/warnings ]] || fail "$page: $(head -3 "$scratch/warnings")"
done
for command in "${commands[@]}"; do
    page=$(MANWIDTH=80 man -l "$papers/man/ashimpact-$command.1" | col -b)
    while read -r option; do expect "$page" "$option" "man page of $command"; done < <(
        "$program" "$command" --help | grep -o -- ' --[a-z][a-z-]*' | sort -u)
    expect "$(<"$papers/reference/commands.md")" "## ashimpact $command" 'reference page'
done

echo '== completion for bash'
# shellcheck source=/dev/null
source "$papers/bash/ashimpact"
compopt() { :; }  # there is no completion going on here
complete_words() {  # the words typed, the last of them to be completed
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _ashimpact
    printf '%s\n' "${COMPREPLY[@]}"
}
expect "$(complete_words ashimpact crit)" critical-velocity 'a command'
expect "$(complete_words ashimpact impact --cont)" --contact-modulus 'an option'
expect "$(complete_words ashimpact impact --law j)" jkr 'a law'
expect "$(complete_words ashimpact impact --law jkr --detachment pull)" pull-off 'a detachment'
expect "$(complete_words ashimpact impact --radius '"44 u')" '44 um' 'a unit in an open quote'
expect "$(complete_words ashimpact impact --velocity 2)" '2 m/s' 'a unit after a bare number'
expect "$(complete_words ashimpact run --from f)" fit 'a stage'
expect "$(complete_words ashimpact schema 7)" 7-critical-velocity 'a schema'
mkdir "$scratch/cases" && touch "$scratch/cases/case.json" "$scratch/cases/notes.txt"
found=$(complete_words ashimpact run "$scratch/cases/")
expect "$found" case.json 'a case file'
[[ $found != *notes.txt* ]] || fail 'a file of another kind is offered'
[[ -z $(complete_words ashimpact impact --json --velocity '"2 kg') ]] || fail 'a unit of another dimension is offered'

echo '== completion for zsh'
if command -v zsh >/dev/null; then
    zsh -n "$papers/zsh/_ashimpact" || fail 'zsh cannot parse its completion'
    cat >"$scratch/try.zsh" <<'ZSH'
zmodload zsh/zpty
zpty shell zsh -f -i
drain() { local line; repeat 60; do zpty -r -t shell line && print -rn -- "$line" || sleep 0.05; done }
zpty -w shell "PS1=; unsetopt zle_bracketed_paste; fpath=($1 \$fpath); autoload -U compinit; compinit -u -d $2/dump"
drain >/dev/null
zpty -w -n shell $'ashimpact impact --law \t\t'
drain
ZSH
    offered=$(zsh -f "$scratch/try.zsh" "$papers/zsh" "$scratch")
    expect "$offered" brach-dunn 'laws in zsh'
    expect "$offered" thornton-ning 'laws in zsh'
else
    leave_out 'zsh is not installed, its completion was not tried (./dev deps library)'
fi
