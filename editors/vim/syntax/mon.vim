" Vim syntax of .mon files: TCCA monitors. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT

if exists("b:current_syntax")
  finish
endif

syntax case match
syntax iskeyword @,48-57,_,-,.

syntax keyword monConstant false true
syntax keyword monDeclaration channel
syntax keyword monModifier after hysteresis over persist rate stale
syntax keyword monOperator above below to
syntax match monNumber "\<\d\+\(\.\d\+\)\?\([eE][+-]\?\d\+\)\?\(\s*\(d\|h\|min\|mins\|ms\|ns\|s\|us\|w\|weeks\)\>\)\?"
syntax region monString start=+"+ skip=+\\["\\]+ end=+"+ oneline
syntax match monComment "//.*$" contains=@Spell
syntax region monComment start="/\*" end="\*/" contains=@Spell
highlight default link monConstant Constant
highlight default link monDeclaration Structure
highlight default link monModifier StorageClass
highlight default link monOperator Operator
highlight default link monNumber Number
highlight default link monString String
highlight default link monComment Comment

let b:current_syntax = "mon"
