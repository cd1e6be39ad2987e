# one_main.awk - the main() of several programs that are linked into one.
#
#     echo NAME... | awk -f tests/tools/one_main.awk > MAIN.c
#
# NAME.o has main_NAME(), and the name by which the whole is called (argv[0]) says
# which of them is meant.

{
    print "int strcmp(const char *, const char *);"
    for (k = 1; k <= NF; k++) {
        print "int main_" $k "(int, char **);"
        all = all "    if (!strcmp(v[0], \"" $k "\")) return main_" $k "(c, v);\n"
    }
    print "int main(int c, char **v) {\n" all "    return 2;\n}"
}
