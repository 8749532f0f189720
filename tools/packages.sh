# The Debian packages of the project, and how to get those that are missing. Sourced by ./setup and ./check.

build_packages=(g++ cmake ninja-build pkg-config libcairo2-dev libpng-dev libjpeg62-turbo-dev libstb-dev libdeflate-dev libfmt-dev
  libtomlplusplus-dev libmuparser-dev libpugixml-dev libpolyclipping-dev libboost-program-options-dev libtbb-dev
  zlib1g-dev)

# What the tests need besides.
test_packages=(libgtest-dev nlohmann-json3-dev)

# What ./check --full needs besides.
full_packages=(adwaita-icon-theme tango-icon-theme contextfree libplot-dev clang-14 clang-format-14 libclang-rt-14-dev librsvg2-bin mupdf-tools poppler-utils
  qpdf libxml2-utils pngcheck python3-shapely)

# install_packages NAME...: installs those that dpkg does not know as installed; does nothing and needs no network when
# all are there. As a plain user with sudo it asks for the password; without sudo it says what to run.
install_packages() {
  local missing=() name as_root=()
  for name in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null || true) == installed ]] || missing+=("$name")
  done
  if ((${#missing[@]} == 0)); then
    return
  fi
  if ((EUID != 0)); then
    if ! command -v sudo > /dev/null; then
      echo "error: packages are missing, and only root may install them; as root run this, then $0 again:" >&2
      echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "installing: ${missing[*]}"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq update
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Dpkg::Use-Pty=0 install \
    --no-install-recommends "${missing[@]}" > /dev/null
}
