#compdef glibra
# zsh completion of glibra, written by `glibra completion zsh`
_glibra() {
    local -a commands
    commands=(
{{#subcommands}}
        '{{command}}:{{summary}}'
{{/subcommands}}
    )
    if (( CURRENT == 2 )); then
        _describe command commands
        _files
        return
    fi
    local command=$words[2]
    shift words
    (( CURRENT-- ))
    case $command in
        help) _describe command commands ;;
{{#subcommands}}
        {{command}}) _arguments{{#forms}} \
                '*{{form}}[{{help}}]{{#placeholder}}:{{placeholder}}:{{#words}}({{words}}){{/words}}{{^words}}_files{{#folder}} -/{{/folder}}{{/words}}{{/placeholder}}'{{/forms}} \
                '{{#arguments}}{{#words}}:word:({{words}})' '{{/words}}{{/arguments}}*:file:_files' ;;
{{/subcommands}}
        *) _files ;;
    esac
}
if [ "$funcstack[1]" = _glibra ]; then _glibra "$@"; else compdef _glibra glibra; fi
