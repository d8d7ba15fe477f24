# fish completion of glibra, written by `glibra completion fish`
{{#subcommands}}
complete -c glibra -n __fish_use_subcommand -a {{command}} -d '{{summary}}'
{{#options}}
complete -c glibra -n '__fish_seen_subcommand_from {{command}}'{{#letter}} -s {{letter}}{{/letter}}{{#name}} -l {{name}}{{/name}}{{#words}} -x -a '{{words}}'{{/words}}{{^words}}{{#folder}} -x -a '(__fish_complete_directories)'{{/folder}}{{^folder}}{{#placeholder}} -r{{/placeholder}}{{/folder}}{{/words}} -d '{{help}}'
{{/options}}
{{#arguments}}
{{#words}}
complete -c glibra -n '__fish_seen_subcommand_from {{command}}' -f -a '{{words}}' -d '{{help}}'
{{/words}}
{{/arguments}}
{{/subcommands}}
complete -c glibra -n '__fish_seen_subcommand_from help' -x -a '{{#subcommands}}{{^first}} {{/first}}{{command}}{{/subcommands}}'
