# bash completion of glibra, written by `glibra completion bash`
_glibra() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=glibra options=
    [ "$COMP_CWORD" -lt 2 ] || command=${COMP_WORDS[1]}
    COMPREPLY=()
    case $command:$before in
{{#commands}}
{{#options}}
{{#placeholder}}
        {{command}}:{{long}}{{#short}}|{{command}}:{{short}}{{/short}}) COMPREPLY=($(compgen {{#words}}-W '{{words}}'{{/words}}{{^words}}{{#folder}}-d{{/folder}}{{^folder}}-f{{/folder}}{{/words}} -- "$word")); return ;;
{{/placeholder}}
{{/options}}
{{/commands}}
    esac
    case $command in
{{#commands}}
        {{command}}) options='{{#options}}{{^first}} {{/first}}{{#short}}{{short}} {{/short}}{{long}}{{/options}}' ;;
{{/commands}}
    esac
    case $word in
        -*) COMPREPLY=($(compgen -W "$options" -- "$word")); return ;;
    esac
    if [ "$COMP_CWORD" -eq 1 ] || [ "$command" = help ]; then
        COMPREPLY=($(compgen -W '{{#subcommands}}{{^first}} {{/first}}{{command}}{{/subcommands}}' -- "$word"))
        [ "$command" != help ] || return
    fi
    COMPREPLY+=($(compgen -f -- "$word"))
}
complete -o filenames -F _glibra glibra
