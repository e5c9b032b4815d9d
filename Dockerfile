# The package on Debian 12, which carries ROS 1 itself: docker build -t tether_monitor . && docker run -it tether_monitor
# For ROS Noetic: --build-arg BASE=ros:noetic. Neither image was built where this was written; its commands were run on Debian 12.
ARG BASE=debian:12
FROM ${BASE}
COPY . /tether_monitor
WORKDIR /tether_monitor
RUN apt-get update && ./scripts/install_dependencies && rm -rf /var/lib/apt/lists/*
RUN bash -c '. scripts/environment.sh; build all'
CMD ["./scripts/demo"]
