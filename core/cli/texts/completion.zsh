#compdef wrinkle
# Completion for zsh: as _wrinkle in a folder of $fpath, or in ~/.zshrc after compinit:
#   source <(wrinkle completion zsh)
_wrinkle() {
    local -a found
    found=(${(f)"$(${(Q)words[1]} complete -- "${(@Q)words[2,CURRENT]}" 2>/dev/null)"})
    if (( ! $#found )); then
        _files
        return
    fi
    compadd -S '' -- ${(M)found:#*/}
    compadd -- ${found:#*/}
}
if [[ $funcstack[1] == _wrinkle ]]; then
    _wrinkle "$@"
else
    compdef _wrinkle wrinkle
fi
