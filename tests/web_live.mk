# web_live.mk - the live scenes and the least model as pages: build/web/web/live.html,
# tissue.html and choose.html, whose sources are in lessons/web/.

# A live scene is on the page, and waits for its frames (common/motion/window_web.c):
# what calls main() alone is made so that it can stop.
WASM_FILES := -sFORCE_FILESYSTEM=1 -sEXPORTED_RUNTIME_METHODS=FS
WASM_LIVE  := $(WASM_FILES) -sENVIRONMENT=web -sASYNCIFY=1 -sASYNCIFY_IGNORE_INDIRECT=1
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

$(T)/web-live.result: $(BUILD)/web/web/choose_data.js $(BUILD)/solutions/24_live \
        $(BUILD)/choose $(wildcard tests/web/*)
	$(call say,test,live scenes and the least model in a browser)
	$(Q)mkdir -p $(@D) && { node tests/web/live.mjs $(BUILD)/web \
	        $(BUILD)/solutions/24_live; \
	    node tests/web/choose.mjs $(BUILD)/web $(BUILD)/choose; } > $(T)/web-live.log \
	    2>&1; grep -E '^(ok|FAIL) ' $(T)/web-live.log > $@; \
	grep -q '^ok web: no error on the page of the least model' $@ || \
	    echo 'FAIL web: the tests in the browser did not end:' \
	        "$$(tail -n 5 $(T)/web-live.log | tr '\n' ' ')" >> $@

# Is a mistake in their scripts noticed?
$(T)/web-mistakes.result: $(T)/web-live.result tests/web/mistakes.mjs
	$(call say,test,mistakes in the live pages)
	$(Q)mkdir -p $(@D) && node tests/web/mistakes.mjs $(BUILD)/web \
	    $(BUILD)/solutions/24_live $(BUILD)/choose > $@ 2>&1 || :
.PHONY: test-web
test-web: $(T)/web-live.result $(T)/web-mistakes.result
