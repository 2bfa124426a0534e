autocmd BufNewFile,BufRead *.glib setfiletype glib
