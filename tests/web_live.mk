# web_live.mk - the live scenes and the least model as pages: build/web/web/live.html,
# tissue.html and choose.html, whose sources are in lessons/web/.

# A live scene is on the page, and waits for its frames (common/motion/window_web.c):
# what calls main() alone is made so that it can stop.
WASM_LIVE  := $(WASM_FILES) -sENVIRONMENT=web -sASYNCIFY=1 -sASYNCIFY_IGNORE_INDIRECT=1
-include $(wildcard $(WASM)/lessons/web/*.d)
WINDOW     := $(WASM)/common/motion/window_web.o
$(WASM)/lessons/web/tissue.o: $(WASM)/%.o: %.c tests/web.mk $(WASM)/gsl/libgsl.a
	$(call say,emcc,$<)
	$(Q)$(HERE) && $(WASM_CC) $(NAMED_MAIN) -c $< -o $@
$(eval $(call wasm_programs,live,$(WASM)/solutions/24_live.o \
    $(WASM)/lessons/web/tissue.o,$(WINDOW),$(WASM_LIVE)))

# The words of a scene file, for the form.
$(BUILD)/lessons/web/form: lessons/web/form.c $(LIB)
	$(Q)$(HERE) && $(COMPILE) $< $(PLACED)
$(WASM)/choose_data.js: $(BUILD)/lessons/web/form $(BUILD)/choose tests/tools/web_choose.sh \
        common/choice/scene_file.h $(wildcard lessons/scenes/* lessons/[0-9]*.md)
	$(Q)$(HERE) && $(WHOLE) $< > $(WASM)/words.tsv && \
	    $(BUILD)/choose -h > $(WASM)/choose.help && sh tests/tools/web_choose.sh \
	    $(WASM)/words.tsv $(WASM)/choose.help > $(PART) && $(MOVED)

# Into the pages that web.mk has made: what of them leads here, and what runs.
$(BUILD)/web/web/choose_data.js: $(BUILD)/web/index.html $(WASM)/choose_data.js \
        $(WASM)/live.js tests/tools/web_live.js
	$(call say,web,live scenes and the least model)
	$(Q)node tests/tools/web_live.js $(WASM) $(BUILD)/web
web-pages: $(BUILD)/web/web/choose_data.js

# In a headless Chromium: the scenes, the form, the pictures, and whether a mistake in
# their scripts is noticed.
$(foreach t,$(WEB_TESTS),$(eval $(call web_test,$t,node tests/web/$(t:web-%=%).mjs \
    $(BUILD)/web $(BUILD)/solutions/24_live $(BUILD)/choose)))
$(T)/web-pictures.result: tests/tools/web_small.js
$(T)/web-mistakes.result: tests/web/live.mjs tests/web/choose.mjs
