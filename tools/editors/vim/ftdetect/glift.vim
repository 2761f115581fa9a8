autocmd BufRead,BufNewFile *.glift setfiletype glift
