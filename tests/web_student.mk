# web_student.mk - what a page needs to compile and judge a student's file: the folder
# build/web/student/, which lessons/web/student.js reads.
#
# The compiler is clang with wasm-ld as WebAssembly, the npm package @yowasp/clang.  What
# the student's object is linked with is compiled beforehand, by emscripten's clang, with
# the headers of that package: it has one libc with the student's.

WASI := $(BUILD)/wasi
SITE := $(WASI)/site
YOWASP := $(BUILD)/source/node_modules/@yowasp/clang/gen
WASI_EMULATED := SIGNAL GETPID PROCESS_CLOCKS MMAN
WASI_CC = $(call once,llvm)/clang --target=wasm32-wasi -nostdinc \
          -isystem $(WASI)/usr/include/wasm32-wasip1 \
          -isystem $$($(call once,llvm)/clang -print-resource-dir)/include

# Of the package what C for wasm32-wasi needs.
$(WASI)/usr: $(YOWASP)/llvm-resources.tar tests/web_student.mk
	$(call say,wasi,$@)
	$(Q)rm -rf $@ && mkdir -p $@ && tar -C $@ -xf $< --wildcards --wildcards-match-slash \
	    'include/wasm32-wasip1/*' 'include/__std*' 'include/__float*' 'include/std*.h' \
	    'include/float.h' 'include/limits.h' 'include/inttypes.h' 'include/iso646.h' \
	    'include/tgmath.h' 'lib/wasm32-wasip1/crt1-command.o' \
	    'lib/wasm32-wasip1/libc.a' 'lib/wasm32-wasip1/libwasi-emulated-*.a' \
	    'lib/wasm32-unknown-wasip1/libclang_rt.builtins.a' && \
	    rm -rf $@/include/wasm32-wasip1/c++ && touch $@
$(WASI)/libgsl.a: $(WASM)/gsl/libgsl.a $(WASI)/usr tests/tools/web_gsl.sh
	$(call say,wasi,GSL)
	$(Q)BUILD='$(BUILD)' CC='$(WASI_CC)' sh tests/tools/web_gsl.sh wasi

WASI_LIBRARY := $(patsubst $(BUILD)/%,$(WASI)/%,$(filter $(BUILD)/common/%,$(OBJECTS)))
WASI_JUDGE := $(WASI)/tests/web/child.o $(patsubst $(BUILD)/%,$(WASI)/%, \
                  $(filter-out %/child.o %/confine.o %/sight.o,$(JUDGE)))
WASI_CHECKS := $(LESSONS:%=$(WASI)/tests/checks/%.o)
$(WASI_CHECKS): $(WASI)/tests/checks/%.o: $(CHECKS)/%.h
$(WASI_CHECKS): OWN = -O1 -fsanitize=bounds -fsanitize-trap=bounds -I. \
                      -DPROGRAM='"$(CHECKS)/$(*F).h"'
$(WASI_LIBRARY) $(WASI_JUDGE) $(WASI_CHECKS) $(WASI)/tests/web/view.o: $(WASI)/%.o: %.c \
        tests/web_student.mk $(WASI)/usr $(WASM)/gsl/libgsl.a
	$(call say,wasi,$<)
	$(Q)$(HERE) && $(WASI_CC) $(STD) -Icommon $(WASI_EMULATED:%=-D_WASI_EMULATED_%) \
	    -include tests/web/posix.h -I$(WASM)/gsl -w -MMD -MP -MF $@.d -MT $@ \
	    -O2 -Itests/checks -DBUILD_FLAGS='"-O2"' $(OWN) -c $< -o $@
$(WASI)/libworkbook.a: $(WASI_LIBRARY)
$(WASI)/libjudge.a: $(WASI_JUDGE)

# Into the page: all that a lesson needs, and what all of them do.
WASI_COMPILER := $(addprefix $(SITE)/,clang.js.gz llvm.core.wasm.gz llvm.core2.wasm.gz \
                     llvm.core3.wasm.gz llvm.core4.wasm.gz library.tar.gz)
$(LESSONS:%=$(SITE)/%.tar.gz): $(SITE)/%.tar.gz: $(WASI)/tests/checks/%.o $(CHECKS)/%.h \
        $(CHECKS)/%.calls $(CHECKS)/%.words $(BUILD)/mistakes/%/all.c $$(wildcard figures/$$*/hand.c) \
        $(WASI_COMPILER) $(addprefix tests/,tools/web_lesson.sh tools/web_kept.mjs web/student_node.mjs) \
        $(addprefix lessons/web/student,_compile.js _judge.js)
	$(call say,wasi,$@)
	$(Q)$(WHOLE) BUILD='$(BUILD)' sh tests/tools/web_lesson.sh $* $< $(SITE) > $(PART) && $(MOVED)
$(SITE)/library.tar.gz: $(WASI)/usr $(WASI)/tests/web/view.o $(addprefix $(WASI)/lib,gsl.a workbook.a judge.a) \
        $(wildcard common/*/*.h tests/checks/*.h tests/oracle/*.h)
	$(call say,wasi,$@)
	$(Q)$(WHOLE) tar -cf $(PART) --sort=name --owner=0 --group=0 --mtime=@0 \
	    common/*/*.h tests/checks/*.h tests/oracle/*.h tests/web/posix.h -C $(WASM)/gsl gsl \
	    -C $(abspath $(WASI)) usr libgsl.a libworkbook.a libjudge.a -C tests/web view.o \
	    && gzip -9n < $(PART) > $@.gz && mv $@.gz $@
$(SITE)/clang.js.gz: $(YOWASP)/bundle.js tests/web_student.mk
	$(Q)$(HERE) && { cat $< && echo 'export { Application, instantiate };'; } | gzip -9n > $@
$(SITE)/%.wasm.gz: $(YOWASP)/%.wasm
	$(call say,wasi,$@)
	$(Q)$(HERE) && gzip -9n < $< > $@
WASI_SITE := $(WASI_COMPILER) $(LESSONS:%=$(SITE)/%.tar.gz)
