" Vim syntax of .tcca files: TCCA plant model. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT

if exists("b:current_syntax")
  finish
endif

syntax case match
syntax iskeyword @,48-57,_,-,.

syntax keyword tccaConstant false inf true
syntax keyword tccaControl after when with
syntax keyword tccaDeclaration component control domain fault import mode module observe plant
syntax keyword tccaFunction erlang exponential likely noplan normal possible surprise uniform weibull
syntax keyword tccaModifier any default initial input internal model nominal output progress rate restart reward
syntax keyword tccaOperator and in not or
syntax match tccaNumber "\<\d\+\(\.\d\+\)\?\([eE][+-]\?\d\+\)\?\(\s*\(d\|h\|min\|mins\|ms\|ns\|s\|us\|w\|weeks\)\>\)\?"
syntax region tccaString start=+"+ skip=+\\["\\]+ end=+"+ oneline
syntax match tccaComment "//.*$" contains=@Spell
syntax region tccaComment start="/\*" end="\*/" contains=@Spell
highlight default link tccaConstant Constant
highlight default link tccaControl Statement
highlight default link tccaDeclaration Structure
highlight default link tccaFunction Function
highlight default link tccaModifier StorageClass
highlight default link tccaOperator Operator
highlight default link tccaNumber Number
highlight default link tccaString String
highlight default link tccaComment Comment

let b:current_syntax = "tcca"
