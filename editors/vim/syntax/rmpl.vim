" Vim syntax of .rmpl files: RMPL control program. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT

if exists("b:current_syntax")
  finish
endif

syntax case match
syntax iskeyword @,48-57,_,-,.

syntax keyword rmplConstant false true
syntax keyword rmplControl always choose do donext each elsenext if maintaining next repeat thennext unless watching when whenever with
syntax keyword rmplDeclaration clock constraint control domain import observe variable
syntax keyword rmplFunction likely noplan possible surprise
syntax keyword rmplModifier any default model
syntax keyword rmplOperator and in not or
syntax match rmplNumber "\<\d\+\(\.\d\+\)\?\([eE][+-]\?\d\+\)\?\(\s*\(d\|h\|min\|mins\|ms\|ns\|s\|us\|w\|weeks\)\>\)\?"
syntax region rmplString start=+"+ skip=+\\["\\]+ end=+"+ oneline
syntax match rmplComment "//.*$" contains=@Spell
syntax region rmplComment start="/\*" end="\*/" contains=@Spell
syntax match rmplDefinition "\<[A-Za-z_][A-Za-z0-9_]*\ze\s*("
highlight default link rmplDefinition Identifier
highlight default link rmplConstant Constant
highlight default link rmplControl Statement
highlight default link rmplDeclaration Structure
highlight default link rmplFunction Function
highlight default link rmplModifier StorageClass
highlight default link rmplOperator Operator
highlight default link rmplNumber Number
highlight default link rmplString String
highlight default link rmplComment Comment

let b:current_syntax = "rmpl"
