# Doxygen does not read C++20's nested inline namespaces (it would name robot::Joint): two namespaces, and two ends.
s#^namespace twinbus::inline ([a-z_]+)((::[a-z_]+)?) \{#namespace twinbus { inline namespace \1\2 {#
s#^\}  // namespace twinbus::(common|bridge|control|geometry|launcher|lcmtypes|planner|robot|sim|viewer_log)(::.*)?$#} }#
# Comments as Doxygen reads them: at the head of a file, before and behind a declaration.
1 s#^// ?#/// \\file\n/// #
s#^( *)//([^/]|$)#\1///\2#
s#([;,{}]) +// #\1 ///< #
