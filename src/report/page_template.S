// The bytes of the page as they are: a compiler would need minutes for an array of so many.
        .section .rodata
        .global zenosphere_page_begin
        .global zenosphere_page_end
zenosphere_page_begin:
        .incbin ZENOSPHERE_PAGE
zenosphere_page_end:
        .byte 0
        .section .note.GNU-stack, "", %progbits
