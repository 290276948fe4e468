" Files of the four languages. Made by grammar/editor/generate.
" SPDX-License-Identifier: MIT
autocmd BufRead,BufNewFile *.rmpl setfiletype rmpl
autocmd BufRead,BufNewFile *.tcca setfiletype tcca
autocmd BufRead,BufNewFile *.scn setfiletype scn
autocmd BufRead,BufNewFile *.props setfiletype props
autocmd BufRead,BufNewFile *.mon setfiletype mon
