# web.mk - the workbook in a browser, which alone needs emscripten.
#
# The programs are compiled to WebAssembly under build/wasm/, the pages are made in
# build/web/.  Without the tools `make web` says what to install, and make test
# leaves its part out.

WASM := $(BUILD)/wasm
.PHONY: web web-pages test-web

# Debian's emscripten does not find its acorn under another node than Debian's.
EMCC = NODE_PATH=$${NODE_PATH:-/usr/share/nodejs} emcc
# A worker runs it, with what it needs of Module (lessons/web/programs.js).
WASM_LINK = -O2 -sENVIRONMENT=worker -sEXIT_RUNTIME=1 -sFORCE_FILESYSTEM=1 \
            -sEXPORTED_RUNTIME_METHODS=FS -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=1GB \
            -Wl,--fatal-warnings
# A live scene is on the page, and waits for its frames (common/motion/window_web.c):
# what calls main() alone is made so that it can stop.
$(WASM)/live.js: WASM_LINK += -sENVIRONMENT=web -sASYNCIFY=1 -sASYNCIFY_IGNORE_INDIRECT=1

$(WASM)/gsl/libgsl.a: tests/tools/web_gsl.sh
	$(call say,emcc,GSL)
	$(Q)BUILD='$(BUILD)' sh tests/tools/web_gsl.sh build
WASM_LIBRARY := $(patsubst $(BUILD)/%,$(WASM)/%,$(CHOOSE) $(filter \
                    $(BUILD)/common/%,$(filter-out %/hand.o,$(OBJECTS))))
WASM_MAINS := $(patsubst %,$(WASM)/%.o,$(LESSONS:%=solutions/%) lessons/choose/choose)
WASM_SCENES := $(addprefix $(WASM)/,solutions/24_live.o lessons/web/tissue.o \
                   common/motion/window_web.o)
WASM_OBJECTS := $(sort $(WASM_LIBRARY) $(WASM_MAINS) $(WASM_SCENES))
$(WASM_OBJECTS): $(WASM)/%.o: %.c tests/web.mk $(WASM)/gsl/libgsl.a
	$(call say,emcc,$<)
	$(Q)$(HERE) && $(EMCC) $(STD) -O2 -w -Icommon -I$(WASM)/gsl -MMD -MP -MF $@.d \
	    -MT $@ -DBUILD_FLAGS='"-O2"' -Dmain=main_$(notdir $*) -c $< -o $@
$(WASM)/libworkbook.a: $(WASM_LIBRARY)
$(WASM)/libworkbook.a $(BUILD)/wasi/libworkbook.a $(BUILD)/wasi/libjudge.a:
	$(Q)rm -f $@ && emar rcs $@ $^

# Scripts of programs, which have most of their code in common.
$(WASM)/lessons.js: $(WASM_MAINS)
$(WASM)/live.js: $(WASM_SCENES)
$(WASM)/lessons.js $(WASM)/live.js: $(WASM)/%.js: $(WASM)/libworkbook.a $(WASM)/gsl/libgsl.a \
        tests/web.mk tests/tools/web_program.js tests/tools/one_main.awk
	$(call say,wasm,$@)
	$(Q)echo $(basename $(notdir $(filter-out %/window_web.o,$(filter %.o,$^)))) | \
	    awk -f tests/tools/one_main.awk > $@.part.c && $(EMCC) $(WASM_LINK) $@.part.c \
	    $(filter %.o,$^) $(filter %.a,$^) -o $@.part.js && node tests/tools/web_program.js \
	    $* $@.part.js $@.part.wasm > $@ && rm $@.part.*

WEB_FILES := $(wildcard lessons/web/*) tests/tools/web_pages.js tests/tools/web_front.js \
             tests/tools/web_small.js
# of the pictures as they are: a newer one is copied, none is drawn
newer = $(if $(shell find figures -name '*.[sg][vi][gf]' -newer $1 2>/dev/null),always)
$(WASM)/book/index.html: $(BOOK) tests/tools/book.sh $(call newer,$(WASM)/book/index.html)
	$(Q)BUILD=$(WASM) sh tests/tools/book.sh > /dev/null
$(WASM)/editor.js: lessons/web/editor.mjs tests/tools/web_editor.js
	$(call say,bundle,$@)
	$(Q)BUILD='$(BUILD)' node tests/tools/web_editor.js $@
$(BUILD)/web/index.html: $(WASM)/book/index.html $(WEB_FILES) $(wildcard lessons/[0-9]*.c) \
        $(WASM)/editor.js $(WASM)/lessons.js $(PROGRAMS) $(PROGRAMS:=.judge)
	$(call say,web,$(@D))
	$(Q)BUILD='$(BUILD)' node tests/tools/web_pages.js $(WASM)/book $(BUILD) $(@D) $(LESSONS)

# The words of a scene file are those of the form.
$(BUILD)/lessons/web/form: lessons/web/form.c $(LIB)
	$(Q)$(HERE) && $(COMPILE) $< $(PLACED)
$(WASM)/choose_data.js: $(BUILD)/lessons/web/form $(BUILD)/choose tests/tools/web_choose.sh \
        common/choice/scene_file.h $(wildcard lessons/scenes/* lessons/[0-9]*.md)
	$(Q)$(HERE) && $(WHOLE) sh tests/tools/web_choose.sh $(BUILD) > $(PART) && $(MOVED)
include tests/web_student.mk

# Into these pages: the live scenes, the least model, the compiler and the judges, with
# what leads there.
$(BUILD)/web/student/files.json: $(BUILD)/web/index.html $(WASM)/choose_data.js \
        $(WASM)/live.js $(WASI_SITE) tests/tools/web_live.js
	$(call say,web,$(@D))
	$(Q)node tests/tools/web_live.js $(WASM) $(BUILD)/web $(WASI_SITE)
web-pages: $(BUILD)/web/student/files.json ; @:
WEB = BUILD='$(BUILD)' COMPILE='$(PLAIN) -O1 -g0' OBJECTS='$(LIB)' LIBS='$(LIBS)' \
      sh tests/tools/web.sh
web: ; @$(SHARED)$(WEB) pages

# ---- in a headless Chromium: once the pages are made, each test is by itself.  What
# is missing for them is said in one line.
WEB_TESTS := $(addprefix web-,write live choose pictures mistakes judge panel student)
WEB_RESULTS := $(call results,web-small web-pages web $(WEB_TESTS))
test-web: $(WEB_RESULTS)
	@if grep -h '^skip web: ' $^; then :; else cat $^ | sh tests/tools/count.sh; fi
$(T)/web-pages.result: $(BOOK) $(WEB_FILES) $(wildcard tests/web*.mk common/*/* solutions/*.c \
        tests/checks/*.[ch] tests/tools/*web* lessons/scenes/* lessons/choose/* tests/web/*.[ch]) \
        $(call newer,$(WASM)/book/index.html) $(LESSONS:%=$(BUILD)/data/%.tsv) \
        $(LESSONS:%=$(BUILD)/solutions/%.judge) $(BUILD)/choose $(LESSONS:%=$(BUILD)/mistakes/%/all.judge)
	$(call RESULT,the pages for a browser,$(WEB) test)
$(T)/web-small.result: tests/web/small.mjs tests/tools/web_small.js \
        $(call newer,$(T)/web-small.result)
	$(call RESULT,$<,$(WEB) small)
$(T)/web.result: tests/cli/web.js $(T)/web-pages.result tests/tools/browser.js
	$(call RESULT,$<,$(WEB) run node $< $(BUILD))
$(call results,$(WEB_TESTS)): $(T)/web-%.result: tests/web/%.mjs $(T)/web-pages.result \
        $(wildcard tests/web/*.mjs) tests/tools/browser.js tests/tools/web_small.js $(LIB)
	$(call RESULT,$<,$(WEB) run node $< $(BUILD)/web $(BUILD))
