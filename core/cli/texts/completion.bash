# Completion for bash. Either read it in ~/.bashrc:
#   source <(wrinkle completion bash)
# or put it where bash-completion looks: share/bash-completion/completions/wrinkle
_wrinkle() {
    local i
    mapfile -t COMPREPLY < <("$1" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    for i in "${!COMPREPLY[@]}"; do printf -v "COMPREPLY[i]" %q "${COMPREPLY[i]}"; done
    [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == */ ]] && compopt -o nospace 2>/dev/null
    return 0
}
complete -o default -F _wrinkle wrinkle
