# Shared by the scripts beside it: clang-tidy on all sources, or on what changed. To be sourced behind setup.sh.

# More are for scripts/tidy: ten seconds each are a long time for a change that touches everything.
readonly most_changed=12

# Into a folder of its own: each source by itself, without the precompiled headers of another compiler. What is generated
# is that of the build.
commands_for_tidy() {
  configure "$build/tidy" -DCOBOT_BUILD_TESTS=ON -DCOBOT_PRECOMPILE=OFF -DCOBOT_UNITY=OFF
  sed -i "s#$build/tidy/#$build/#g" "$build/tidy/compile_commands.json"
}

# tidy <source>...
tidy() {
  [ $# -gt 0 ] || { echo "nothing to look at"; return; }
  commands_for_tidy
  # Messages are headers that the build makes; without them nothing that speaks ROS can be read.
  ninja -C "$build" cobot_command_generate_messages_cpp >/dev/null
  printf '%s\0' "$@" | nice xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$build/tidy" --quiet 2> >(grep -v 'warnings generated' >&2)
}

tidy_all() {
  local sources
  mapfile -t sources < <(cd "$root" && git ls-files 'src/*.cpp' 'test/*.cpp' 'examples/*.cpp')
  (cd "$root" && tidy "${sources[@]}")
}

# Where the present work began: the main branch, or the commit before when it is the main branch.
tidy_base() {
  local base
  base=$(git -C "$root" merge-base HEAD origin/main 2>/dev/null) || base=HEAD
  [ "$(git -C "$root" rev-parse HEAD)" = "$(git -C "$root" rev-parse "$base")" ] && base=HEAD~1
  git -C "$root" rev-parse --verify --quiet "$base"
}

# For a header: one source that includes it.
source_for() {
  case $1 in
    *.cpp) echo "$1" ;;
    *.h) grep -rlF --include='*.cpp' "$(basename "$1")\"" "$root/src" "$root/test" | sed "s|^$root/||" | sort | head -n 1 ;;
  esac
}

tidy_changed() {
  local base file changed=()
  base=$(tidy_base) || { echo "no commit to compare with: nothing to look at"; return; }
  mapfile -t changed < <(
    {
      git -C "$root" diff --name-only --diff-filter=d "$base" -- 'src/*' 'include/*' 'test/*' 'examples/*'
      git -C "$root" ls-files --others --exclude-standard -- 'src/*' 'include/*' 'test/*' 'examples/*'
    } | grep -E '\.(h|cpp)$' | while read -r file; do source_for "$file"; done | sort -u
  )
  if [ ${#changed[@]} -gt $most_changed ]; then
    echo "${#changed[@]} sources are concerned; $most_changed of them are looked at, all by scripts/tidy"
    changed=("${changed[@]:0:$most_changed}")
  fi
  (cd "$root" && tidy "${changed[@]}")
}
