# bash completion of glibra, written by `glibra completion bash`
_glibra() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=glibra options=
    [ "$COMP_CWORD" -lt 2 ] || command=${COMP_WORDS[1]}
    COMPREPLY=()
    case $command:$before in
{{#commands}}
{{#options}}
{{#placeholder}}
        {{command}}:{{long}}{{#short}}|{{command}}:{{short}}{{/short}}) mapfile -t COMPREPLY < <(compgen {{#words}}-W '{{words}}'{{/words}}{{^words}}{{#folder}}-d{{/folder}}{{^folder}}-f{{/folder}}{{/words}} -- "$word"); return ;;
{{/placeholder}}
{{/options}}
{{/commands}}
    esac
    case $command in
{{#commands}}
        {{command}}) options='{{#options}}{{^first}} {{/first}}{{#short}}{{short}} {{/short}}{{long}}{{/options}}'{{#isProgram}}$("${COMP_WORDS[0]}" {{command}} --help 2>/dev/null | grep -oE '^ *(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'){{/isProgram}} ;;
{{/commands}}
    esac
    case $word in
        -*) mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word"); return ;;
    esac
    case $COMP_CWORD:$command in
{{#commands}}
{{#arguments}}
{{#words}}
        *:{{command}}) mapfile -t COMPREPLY < <(compgen -W '{{words}}' -- "$word"); return ;;
{{/words}}
{{/arguments}}
{{/commands}}
        1:*|*:help) mapfile -t COMPREPLY < <(compgen -W '{{#subcommands}}{{^first}} {{/first}}{{command}}{{/subcommands}}' -- "$word") ;;
    esac
    [ "$command" != help ] || return
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word")
}
complete -o filenames -F _glibra glibra
