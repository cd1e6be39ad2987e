# web_live.mk - the live scenes and the least model as pages: build/web/web/live.html,
# tissue.html and choose.html, whose sources are in lessons/web/.

# A live scene is on the page, and waits for its frames (common/motion/window_web.c):
# what calls main() alone is made so that it can stop.
WASM_FILES := -sFORCE_FILESYSTEM=1 -sEXPORTED_RUNTIME_METHODS=FS
WASM_LIVE  := $(WASM_FILES) -sENVIRONMENT=web -sASYNCIFY=1 -sASYNCIFY_IGNORE_INDIRECT=1
-include $(wildcard $(WASM)/lessons/web/*.d)
WINDOW     := $(WASM)/common/motion/window_web.o
$(WASM)/lessons/web/tissue.o: $(WASM)/%.o: %.c tests/web.mk $(WASM)/gsl/libgsl.a
	$(call say,emcc,$<)
	$(Q)mkdir -p $(@D) && $(WASM_CC) -c $< -o $@
$(eval $(call wasm_program,square,$(WASM)/solutions/24_live.o $(WINDOW),$(WASM_LIVE)))
$(eval $(call wasm_program,tissue,$(WASM)/lessons/web/tissue.o $(WINDOW),$(WASM_LIVE)))
$(eval $(call wasm_program,choose,$(WASM)/common/choice/choose.o,$(WASM_FILES)))

# The words of a scene file, for the form.
$(BUILD)/lessons/web/form: lessons/web/form.c $(LIB)
	$(Q)mkdir -p $(@D) && $(COMPILE) $< $(PLACED)
$(WASM)/choose_data.js: $(BUILD)/lessons/web/form $(BUILD)/choose tests/tools/web_choose.sh \
        common/choice/scene_file.h $(wildcard lessons/scenes/* lessons/[0-9]*.md)
	$(Q)mkdir -p $(@D) && $(WHOLE) $< > $(WASM)/words.tsv && \
	    $(BUILD)/choose -h > $(WASM)/choose.help && sh tests/tools/web_choose.sh \
	    $(WASM)/words.tsv $(WASM)/choose.help > $(PART) && $(MOVED)

# Into the pages that web.mk has made: what of them leads here, and what runs.
LIVE_PROGRAMS := square tissue choose
$(BUILD)/web/web/choose_data.js: $(BUILD)/web/index.html $(WASM)/choose_data.js \
        $(LIVE_PROGRAMS:%=$(WASM)/%.js) tests/tools/web_live.js
	$(call say,web,live scenes and the least model)
	$(Q)node tests/tools/web_live.js $(WASM) $(BUILD)/web $(LIVE_PROGRAMS)
web-pages: $(BUILD)/web/web/choose_data.js

# In a headless Chromium: the scenes, the form, and whether a mistake in their
# scripts is noticed.  The pages are those that the test before has made: three at
# once would make them over each other.
LIVE_TESTS := $(patsubst %,$(T)/web-%.result,live choose mistakes)
$(LIVE_TESTS): $(T)/web-%.result: $(T)/web.result $(wildcard tests/web/*) \
        tests/web_live.mk $(wildcard lessons/scenes/*) $(BUILD)/solutions/24_live \
        $(BUILD)/choose
	$(call say,test,tests/web/$*.mjs)
	$(SHARED)$(Q)mkdir -p $(@D) && if grep -q '^skip web: ' $<; then : > $@; else \
	    node tests/web/$*.mjs $(BUILD)/web $(BUILD)/solutions/24_live \
	        $(BUILD)/choose > $@ 2> $@.log || \
	    grep -q '^FAIL' $@ || { echo 'FAIL web: tests/web/$*.mjs:' \
	        "$$(tail -n 5 $@.log | tr '\n' ' ')"; } >> $@; fi
	@grep 'frames per second' $@ || :
test-web: $(LIVE_TESTS)
