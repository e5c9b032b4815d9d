# Sourced by the other scripts: where ROS is, and how the package is built.
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
BUILD="$ROOT/.build/default"

# Debian's own ROS wants Debian's own python in front.
export PATH=/usr/sbin:/usr/bin:/sbin:/bin
unset PYTHONPATH CMAKE_PREFIX_PATH
export ROS_HOSTNAME=localhost
if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u
  # shellcheck disable=SC1091
  . /opt/ros/noetic/setup.bash
  set -u
fi

install_dependencies() {
  "$ROOT/scripts/install_dependencies" "$@"
}

# build TARGET...: configures if needed and builds; CONFIGURE holds further options.
build() {
  cmake -S "$ROOT" -B "$BUILD" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCATKIN_ENABLE_TESTING=ON -DCMAKE_INSTALL_PREFIX="$BUILD/install" ${CONFIGURE:-} > "$ROOT/.build/configure.log" 2>&1 \
    || { cat "$ROOT/.build/configure.log"; return 1; }
  cmake --build "$BUILD" --target "$@"
}

load_workspace() {
  set +u
  # shellcheck disable=SC1091
  . "$BUILD/devel/setup.bash"
  set -u
}
