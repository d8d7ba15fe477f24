autocmd BufRead,BufNewFile *.glib setfiletype glib
