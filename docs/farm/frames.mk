# SPDX-License-Identifier: MIT
# make -f frames.mk: draws the frames that are not there, or older than their MODEL, and makes a video of all.

FRAMES ?= 120
FOLDER ?= turn
DRAW   ?= teapot_afd --no-input --backend memory --turntable 3 --size 640x360
MODEL  ?=#  the files that DRAW reads
ON     ?=#  a command that runs another one elsewhere, such as srun

frames := $(shell seq -f '$(FOLDER)/%04g.png' 0 $$(($(FRAMES) - 1)))

$(FOLDER).mp4: $(frames)
	ffmpeg -y -loglevel error -framerate 30 -i $(FOLDER)/%04d.png -frames:v $(FRAMES) -pix_fmt yuv420p $(FOLDER).part.mp4 < /dev/null
	mv $(FOLDER).part.mp4 $@

# When a node dies, srun may end as if all were well.
$(frames): $(FOLDER)/%.png: $(MODEL) | $(FOLDER)
	$(ON) $(DRAW) --threads 1 --output $(FOLDER)/%04d.png --frames $*:$$(expr $* + 1)
	@test -e $@

$(FOLDER):
	mkdir -p $@
