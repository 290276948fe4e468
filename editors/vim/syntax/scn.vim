" Vim syntax of .scn files: RMPL scenario. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT

if exists("b:current_syntax")
  finish
endif

syntax case match
syntax iskeyword @,48-57,_,-,.

syntax keyword scnConstant false finished goal-conflict no-plan true
syntax keyword scnControl after at expect for never when with within
syntax keyword scnDeclaration channel cycle duration fault observe plant program requirement scenario seed truth
syntax keyword scnFunction likely noplan possible surprise
syntax keyword scnModifier command estimate main only rules
syntax keyword scnOperator and in not or
syntax match scnNumber "\<\d\+\(\.\d\+\)\?\([eE][+-]\?\d\+\)\?\(\s*\(cycles\|d\|h\|min\|mins\|ms\|ns\|s\|us\|w\|weeks\)\>\)\?"
syntax region scnString start=+"+ skip=+\\["\\]+ end=+"+ oneline
syntax match scnComment "//.*$" contains=@Spell
syntax region scnComment start="/\*" end="\*/" contains=@Spell
highlight default link scnConstant Constant
highlight default link scnControl Statement
highlight default link scnDeclaration Structure
highlight default link scnFunction Function
highlight default link scnModifier StorageClass
highlight default link scnOperator Operator
highlight default link scnNumber Number
highlight default link scnString String
highlight default link scnComment Comment

let b:current_syntax = "scn"
