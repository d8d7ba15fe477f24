# Filled when the library's public headers stand.
