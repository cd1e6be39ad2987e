# web.mk - the workbook in a browser, which alone needs emscripten.
#
# The programs are compiled to WebAssembly under build/wasm/, the pages are made in
# build/web/.  Without the tools `make web` says what to install, and make test
# leaves its part out.

WASM := $(BUILD)/wasm
# what is not here, in words
WEB_MISSING = BUILD='$(BUILD)' sh tests/tools/web_missing.sh
no_web = not here; make deps-web installs it
.PHONY: web

# Debian's emscripten does not find its acorn under another node than Debian's.
EMCC = NODE_PATH=$${NODE_PATH:-/usr/share/nodejs} emcc
WASM_CC = $(EMCC) $(STD) -O2 -w -Icommon -I$(WASM)/gsl -MMD -MP -MF $@.d -MT $@
# A worker runs it, with what it needs of Module (lessons/web/programs.js).
WASM_LINK = -O2 -sENVIRONMENT=worker -sEXIT_RUNTIME=1 \
            -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=1GB -Wl,--fatal-warnings

$(WASM)/gsl/libgsl.a: tests/tools/web_gsl.sh
	$(call say,emcc,GSL)
	$(Q)BUILD='$(BUILD)' sh tests/tools/web_gsl.sh build
WASM_OBJECTS := $(patsubst %.c,$(WASM)/%.o,$(filter-out \
                    common/motion/view_sdl.c common/motion/hand.c,$(wildcard common/*/*.c)) \
                    $(LESSONS:%=solutions/%.c))
-include $(wildcard $(WASM)/common/*/*.d)
NAMED_MAIN = -Dmain=main_$(notdir $*)
$(WASM_OBJECTS): $(WASM)/%.o: %.c tests/web.mk $(WASM)/gsl/libgsl.a
	$(call say,emcc,$<)
	$(Q)$(HERE) && $(WASM_CC) -DBUILD_FLAGS='"-O2"' $(NAMED_MAIN) -c $< -o $@
$(WASM)/libworkbook.a: $(filter $(WASM)/common/%,$(WASM_OBJECTS))
	$(Q)rm -f $@ && emar rcs $@ $(filter-out %/choose.o,$^)

# Programs that have most of their code in common are one: NAME.o has main_NAME(), and
# the name by which it is called (argv[0]) says which of them is meant.
ONE_MAIN = echo $1 | tr ' ' '\n' | awk ' \
    { print "int main_" $$1 "(int, char **);"; \
      all = all "    if (!strcmp(v[0], \"" $$1 "\")) return main_" $$1 "(c, v);\n" } \
    END { print "int strcmp(const char *, const char *);\nint main(int c, char **v) {\n" \
          all "    return 2;\n}" }'
# A script of programs: $1 its name, $2 their objects, $3 another one that comes before
# the library, $4 options of the link.
define wasm_programs
$(WASM)/$1.js: $2 $3 $(WASM)/libworkbook.a $(WASM)/gsl/libgsl.a tests/web.mk \
        tests/tools/web_program.js
	$$(call say,wasm,$$@)
	$$(Q)$$(call ONE_MAIN,$(basename $(notdir $2))) > $(WASM)/$1.part.c && \
	    $$(EMCC) $$(WASM_LINK) $4 $(WASM)/$1.part.c $$(filter %.o %.a,$$^) \
	        -o $(WASM)/$1.part.js && node tests/tools/web_program.js $1 \
	        $(WASM)/$1.part.js $(WASM)/$1.part.wasm > $$@ && rm $(WASM)/$1.part.*
endef
WASM_FILES := -sFORCE_FILESYSTEM=1 -sEXPORTED_RUNTIME_METHODS=FS
$(eval $(call wasm_programs,lessons,$(LESSONS:%=$(WASM)/solutions/%.o) \
    $(WASM)/common/choice/choose.o,,$(WASM_FILES)))
# For a test: lesson 12, which at its end has an endless loop.
$(WASM)/endless/12_triangles.c: solutions/12_triangles.c
	$(Q)$(HERE) && sed 's/^    return table_finish();/    for (;;);\n&/' $< > $@
	$(Q)grep -q 'for (;;);' $@
$(WASM)/endless/12_triangles.o: $(WASM)/endless/12_triangles.c $(WASM)/gsl/libgsl.a
	$(Q)$(WASM_CC) -Dmain=main_12_triangles -c $< -o $@
$(eval $(call wasm_programs,endless,$(WASM)/endless/12_triangles.o))
.PHONY: wasm web-pages
wasm: $(WASM)/lessons.js $(WASM)/live.js $(WASM)/endless.js ; @:

# What was measured of each prediction.
$(LESSONS:%=$(WASM)/%.measured): $(WASM)/%.measured: $(BUILD)/solutions/%.judge \
        $(BUILD)/solutions/%
	$(Q)$(HERE) && $(WHOLE) $< --measured $(BUILD)/solutions/$* > $(PART) && \
	    $(MOVED)
WEB_FILES := $(wildcard lessons/web/*) tests/tools/web_pages.js tests/tools/web_front.js \
             tests/tools/web_small.js
# of the pictures as they are: a newer one is copied, none is drawn
NEWER = $(shell find figures -name '*.[sg][vi][gf]' -newer $(WASM)/book/index.html \
            2>/dev/null)
$(WASM)/book/index.html: $(BOOK) tests/tools/book.sh $(if $(NEWER),always)
	$(Q)BUILD=$(WASM) sh tests/tools/book.sh > /dev/null
$(WASM)/editor.js: lessons/web/editor.mjs tests/tools/web_editor.js
	$(call say,bundle,$@)
	$(Q)BUILD='$(BUILD)' node tests/tools/web_editor.js $@
$(BUILD)/web/index.html: $(WASM)/book/index.html $(WEB_FILES) $(wildcard lessons/[0-9]*.c) \
        $(WASM)/editor.js $(WASM)/lessons.js $(foreach l,$(LESSONS),$(WASM)/$l.measured $(BUILD)/solutions/$l)
	$(call say,web,$(@D))
	$(Q)BUILD='$(BUILD)' node tests/tools/web_pages.js $(WASM)/book $(BUILD) $(@D) \
	    $(LESSONS)
web-pages: $(BUILD)/web/index.html ; @:
web:
	@missing=$$($(WEB_MISSING)); [ -z "$$missing" ] || \
	    { echo "web: $$missing: $(no_web)" >&2; exit 2; }
	$(SHARED)@"$$MAKE" web-pages && echo '  web      $(BUILD)/web/index.html'

# ---- in a headless Chromium: once the pages are made, each test is by itself.  What
# is missing for them is said in one line.  What was left out or has failed is tried
# again.
WEB_RESULTS := $(patsubst %,$(T)/%.result,web-small web-pages web web-judge web-panel web-student \
                    $(WEB_TESTS))
.PHONY: test-web web-again
test-web: $(WEB_RESULTS)
	@if grep -h '^skip web: ' $^; then :; else cat $^ | sh tests/tools/count.sh; fi
web-again: ;
$(shell grep -lsE '^(FAIL|skip) ' $(WEB_RESULTS)): web-again
$(T)/web-pages.result: $(BOOK) $(WEB_FILES) tests/web.mk tests/web_live.mk $(wildcard \
        common/*/* solutions/*.c tests/checks/*.[ch] tests/tools/web_* lessons/scenes/*) \
        $(if $(NEWER),web-again) $(LESSONS:%=$(BUILD)/data/%.tsv) \
        $(LESSONS:%=$(BUILD)/solutions/%.judge) $(BUILD)/choose
	$(call say,test,the pages for a browser)
	$(SHARED)$(Q)$(HERE) && missing=$$($(WEB_MISSING) chromium); \
	    if [ -n "$$missing" ]; then echo "skip web: $$missing: $(no_web)"; \
	    elif "$$MAKE" wasm web-pages > $@.log 2>&1; then echo 'ok web: the pages are made'; \
	    else echo "FAIL web: the pages are not made: $$(tail -n 20 $@.log)"; fi > $@
# By node alone: a picture that the site cannot take fails where it is drawn.
$(T)/web-small.result: tests/web/small.mjs tests/tools/web_small.js $(if $(shell \
        find figures -name '*.svg' -newer $(T)/web-small.result 2>/dev/null),web-again)
	$(call say,test,$<)
	$(Q)$(HERE) && export BUILD='$(BUILD)' && \
	    if ! node tests/tools/web_small.js > $@.log 2>&1; then \
	    echo 'skip web: node with svgo: $(no_web)'; \
	    else node $< 2> $@.log || grep -q . $@ || echo "FAIL web: $<: $$(cat $@.log)"; \
	    fi > $@
# A test: $1 its name, $2 its command.
define web_test
$(T)/$1.result: $(T)/web-pages.result tests/tools/browser.js $(wildcard $(word 2,$2) \
        tests/web/page.mjs)
	$$(call say,test,$(word 2,$2))
	$(Q)if grep -q '^ok ' $$<; then BUILD='$(BUILD)' COMPILE='$$(PLAIN) -O1 -g0' \
	    OBJECTS='$$(LIB)' LIBS='$$(LIBS)' $2 > $$@ 2> $$@.log || grep -q '^FAIL' $$@ || \
	    echo "FAIL web: $(word 2,$2): $$$$(tail -n 5 $$@.log | tr '\n' ' ')" >> $$@; \
	    else : > $$@; fi
endef
$(eval $(call web_test,web,node tests/cli/web.js $(BUILD)))
