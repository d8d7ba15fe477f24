" Vim syntax file: GLIB shader scenes. Made by `glibra language --grammar vim`.
if exists('b:current_syntax')
  finish
endif
try
  syntax include @glibGlsl syntax/glsl.vim
catch
endtry
unlet! b:current_syntax
syntax case ignore
syntax match glibNumber /\%(\w\|\.\)\@<![+-]\=\%(\d\+\.\=\d*\|\.\d\+\)\%(e[+-]\=\d\+\)\=/
syntax match glibLine /^\s*\h\w*/ contains=glibStatement
syntax match glibContinued /\\\s*$/
syntax region glibString start=/"/ end=/"/ oneline
syntax match glibComment /#.*$/
syntax match glibComment /\/\/.*$/
syntax match glibComment /\S\@1<!\/.*$/
syntax match glibMessage /\%(^\s*MessageBox\)\@<=\s.*$/
{{{keys}}}{{{statements}}}syntax case match
{{{functions}}}{{{names}}}syntax case ignore
{{#stages}}
syntax region glibShader matchgroup=glibStatement start=/^\s*{{.}}\s\+inline\>.*$/ end=/^\s*End{{.}}\s*$/ contains=@glibGlsl keepend
{{/stages}}
syntax sync fromstart
highlight default link glibComment Comment
highlight default link glibStatement Statement
highlight default link glibKey Type
highlight default link glibFunction Function
highlight default link glibName Identifier
highlight default link glibNumber Number
highlight default link glibString String
highlight default link glibMessage String
highlight default link glibContinued Special
let b:current_syntax = 'glib'
