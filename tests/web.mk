# web.mk - the workbook in a browser, which alone needs emscripten.
#
# The programs are compiled to WebAssembly under build/wasm/, the pages are made in
# build/web/.  Without the tools `make web` says what to install, and make test
# leaves its part out.

WASM := $(BUILD)/wasm
WEB_TOOLS = command -v emcc > /dev/null && command -v node > /dev/null && \
            command -v pandoc > /dev/null && \
            [ -n "$$(BUILD='$(BUILD)' sh tests/tools/web_gsl.sh source)" ]
no_web = emscripten, pandoc, chromium or the source of GSL is missing; make \
         deps-web installs them
.PHONY: deps-web web
deps-web: ; @BUILD='$(BUILD)' sh tests/tools/deps_web.sh

# Debian's emscripten does not find its acorn under another node than Debian's.
EMCC = NODE_PATH=$${NODE_PATH:-/usr/share/nodejs} emcc
WASM_CC = $(EMCC) $(STD) -O2 -w -Icommon -I$(WASM)/gsl -MMD -MP -MF $@.d -MT $@
# In a page a program is a function of Module, so that a script may bring it from
# a file as well as from a server: programs["NN_slug"](Module) runs it, with the
# arguments, print, printErr and onExit of Module.
WASM_LINK = -O2 -sSINGLE_FILE=1 -sENVIRONMENT=worker -sEXIT_RUNTIME=1 \
            -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=1GB

$(WASM)/gsl/libgsl.a: tests/tools/web_gsl.sh
	$(call say,emcc,GSL)
	$(Q)BUILD='$(BUILD)' sh tests/tools/web_gsl.sh build
WASM_OBJECTS := $(patsubst %.c,$(WASM)/%.o,$(filter-out \
                    common/motion/window_sdl.c,$(wildcard common/*/*.c)) \
                    $(LESSONS:%=solutions/%.c))
-include $(wildcard $(WASM)/common/*/*.d)
$(WASM_OBJECTS): $(WASM)/%.o: %.c tests/web.mk $(WASM)/gsl/libgsl.a
	$(call say,emcc,$<)
	$(Q)mkdir -p $(@D) && $(WASM_CC) -DBUILD_FLAGS='"-O2"' -c $< -o $@
$(WASM)/libworkbook.a: $(filter $(WASM)/common/%,$(WASM_OBJECTS))
	$(Q)rm -f $@ && emar rcs $@ $(filter-out %/choose.o,$^)

# A program: $1 its name, $2 its objects, $3 what its link needs besides.
define wasm_program
$(WASM)/$1.js: $2 $(WASM)/libworkbook.a $(WASM)/gsl/libgsl.a tests/web.mk
	$$(call say,wasm,$$@)
	$$(Q)$$(EMCC) $$(WASM_LINK) $3 $$(filter %.o %.a,$$^) -o $(WASM)/$1.part.js && \
	    { echo '(self.programs ||= {})["$1"] = function (Module) {' && \
	      cat $(WASM)/$1.part.js && echo '};'; } > $$@ && rm $(WASM)/$1.part.js
endef
$(foreach l,$(LESSONS),$(eval $(call wasm_program,$l,$(WASM)/solutions/$l.o)))
.PHONY: wasm web-pages
wasm: $(LESSONS:%=$(WASM)/%.js) ; @:

# What was measured of each prediction.
$(LESSONS:%=$(WASM)/%.measured): $(WASM)/%.measured: $(BUILD)/solutions/%.judge \
        $(BUILD)/solutions/%
	$(Q)mkdir -p $(@D) && $(WHOLE) $< --measured $(BUILD)/solutions/$* > $(PART) && \
	    $(MOVED)
WEB_FILES := $(wildcard lessons/web/*) tests/tools/web_pages.js
# of the pictures as they are: a newer one is copied, none is drawn
NEWER = $(shell find figures -name '*.[sg][vi][gf]' -newer $(WASM)/book/index.html \
            2>/dev/null)
$(WASM)/book/index.html: $(BOOK) tests/tools/book.sh $(if $(NEWER),always)
	$(Q)BUILD=$(WASM) sh tests/tools/book.sh > /dev/null
$(BUILD)/web/index.html: $(WASM)/book/index.html $(WEB_FILES) \
        $(foreach l,$(LESSONS),$(WASM)/$l.js $(WASM)/$l.measured $(BUILD)/solutions/$l)
	$(call say,web,$(@D))
	$(Q)node tests/tools/web_pages.js $(WASM)/book $(BUILD) $(@D) $(LESSONS)
web-pages: $(BUILD)/web/index.html ; @:
web:
	@$(WEB_TOOLS) || { echo 'web: $(no_web)' >&2; exit 2; }
	$(SHARED)@"$$MAKE" web-pages && echo '  web      $(BUILD)/web/index.html:' \
	    "$$(find $(BUILD)/web -type f | wc -l) files," \
	    "$$(tar -cf - -C $(BUILD)/web . | gzip | wc -c | \
	    awk '{ printf "%.1f", $$1 / 1e6 }') MB as an archive"

# ---- in a headless Chromium
.PHONY: test-web web-again
WEB_TESTS = $(WEB_TOOLS) && command -v chromium > /dev/null
test-web: $(T)/web.result
	@if grep -h '^skip web: ' $^; then :; else cat $^ | sh tests/tools/count.sh; fi
# what was left out is tried again: the tools may be there now
web-again: ;
$(T)/web.result: $(shell grep -qs '^skip web: ' $(T)/web.result && \
        echo web-again) $(BOOK) $(wildcard lessons/web/* common/*/* solutions/*.c \
        tests/checks/*.[ch] tests/tools/web_* tests/tools/b*.* tests/cli/web.js) \
        tests/web.mk tests/web_live.mk $(wildcard lessons/scenes/*) \
        $(LESSONS:%=$(BUILD)/data/%.tsv)
	$(call say,test,the pages in a browser)
	$(SHARED)$(Q)mkdir -p $(@D) && if $(WEB_TESTS); then \
	    "$$MAKE" web-pages > $@.log 2>&1 && node tests/cli/web.js $(BUILD) > $@ || \
	    { echo 'FAIL web:'; tail -n 20 $@.log; } >> $@; \
	else echo 'skip web: $(no_web)' > $@; fi
