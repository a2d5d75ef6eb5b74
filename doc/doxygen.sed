# Comments as Doxygen reads them: at the head of a file, before and behind a declaration.
1 s#^// ?#/// \\file\n/// #
s#^( *)//([^/]|$)#\1///\2#
s#([;,{}]) +// #\1 ///< #
