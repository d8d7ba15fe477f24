# PowerShell completion of glibra, written by `glibra completion powershell`
Register-ArgumentCompleter -Native -CommandName 'glibra', 'glibra.exe' -ScriptBlock {
    param($word, $line, $place)
    $before = @($line.CommandElements | Where-Object { $_.Extent.EndOffset -lt $place } | ForEach-Object { $_.Extent.Text })
    $command = if ($before.Count -gt 1) { $before[1] } else { 'glibra' }
    $offers = @()
    switch -CaseSensitive ($command + ' ' + $before[-1]) {
{{#commands}}
{{#forms}}
{{#placeholder}}
        '{{command}} {{form}}' { {{#words}}$offers = {{#eachWord}}{{^first}}, {{/first}}'{{.}}'{{/eachWord}}{{/words}}{{^words}}return{{/words}} }
{{/placeholder}}
{{/forms}}
{{#arguments}}
{{#words}}
        '{{command}} {{command}}' { $offers = {{#eachWord}}{{^first}}, {{/first}}'{{.}}'{{/eachWord}} }
{{/words}}
{{/arguments}}
{{/commands}}
    }
    if (-not $offers -and $word -like '-*') {
        switch -CaseSensitive ($command) {
{{#commands}}
            '{{command}}' { $offers = @(
{{?forms}}
{{#forms}}{{^first}},
{{/first}}                '{{form}}|{{help}}'{{/forms}}
{{/?forms}}
            ) }
{{/commands}}
        }
    } elseif (-not $offers -and ($before.Count -lt 2 -or $command -ceq 'help')) {
        $offers = @(
{{#subcommands}}{{^first}},
{{/first}}            '{{command}}|{{summary}}'{{/subcommands}}
        )
    }
    foreach ($each in $offers) {
        $offer, $help = $each -split '\|', 2
        if (-not $help) { $help = $offer }
        if ($offer.StartsWith($word, 'Ordinal')) {
            [System.Management.Automation.CompletionResult]::new($offer, $offer, 'ParameterValue', $help)
        }
    }
}
