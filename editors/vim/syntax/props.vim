" Vim syntax of .props files: TCCA properties. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT

if exists("b:current_syntax")
  finish
endif

syntax case match
syntax iskeyword @,48-57,_,-,.

syntax keyword propsConstant catastrophic critical dense endless-wait false goal-conflict holds inf least major minor most no-plan none one stuck true undone violated
syntax keyword propsControl after at eventually expect finally never of probability reach terminates within
syntax keyword propsDeclaration allow-stuck commands entailed faults from hazard program property requirement severity time
syntax keyword propsFunction likely noplan possible surprise
syntax keyword propsModifier any
syntax keyword propsOperator and in not or
syntax match propsNumber "\<\d\+\(\.\d\+\)\?\([eE][+-]\?\d\+\)\?\(\s*\(d\|h\|min\|mins\|ms\|ns\|s\|us\|w\|weeks\)\>\)\?"
syntax region propsString start=+"+ skip=+\\["\\]+ end=+"+ oneline
syntax match propsComment "//.*$" contains=@Spell
syntax region propsComment start="/\*" end="\*/" contains=@Spell
highlight default link propsConstant Constant
highlight default link propsControl Statement
highlight default link propsDeclaration Structure
highlight default link propsFunction Function
highlight default link propsModifier StorageClass
highlight default link propsOperator Operator
highlight default link propsNumber Number
highlight default link propsString String
highlight default link propsComment Comment

let b:current_syntax = "props"
