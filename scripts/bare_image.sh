# A part of scripts/bare_inside, which sources it: makes the image of Containerfile in the machine, and tries it. The base of the image is the
# machine before anything was installed.
# shellcheck shell=bash disable=SC2154
readonly base=localhost/debian:$suite name=localhost/cobot-simulator:$suite

# buildah <argument>...: without overlays and containers, which a process in such a machine cannot make.
buildah() {
  in_machine root "STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot TMPDIR=/var/tmp buildah $*"
}

make_base() {
  mv "$folder/base.tar" "$machine/var/tmp/"
  {
    buildah from --name base scratch
    buildah add --quiet base /var/tmp/base.tar /
    buildah commit --quiet base "$base"
    buildah rm base
  } >/dev/null
  rm "$machine/var/tmp/base.tar"
}

# The settings of apt for this computer are mounted while the image is made, so that they are not in it.
build_image() {
  local volumes=(--volume "$apt_settings:$apt_settings:ro")
  [ ! -f "$machine$certificates" ] || volumes+=(--volume "$certificates:$certificates:ro")
  buildah build --build-arg "BASE=$base" --pull-never --format oci "${volumes[@]}" --file cobot_command/Containerfile --tag "$name" cobot_command
  buildah push --quiet "$name" "oci-archive:/var/tmp/image.tar:$name"
}

say "Installing buildah"
install_in_machine buildah
say "Making an image of this Debian"
make_base
say "Making the image of the simulator"
build_image
say "Trying it"
mkdir "$machine/var/tmp/unpacked"
unshare --net /usr/bin/python3 "$(dirname "$0")/try_image.py" "$machine/var/tmp/image.tar" "$machine/var/tmp/unpacked"
mv "$machine/var/tmp/image.tar" "$folder/image.tar"
