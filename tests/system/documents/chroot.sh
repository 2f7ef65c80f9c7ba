#!/bin/sh
# Follows documents word for word in a bare Debian 12: a fresh chroot with a clone of this tree and nothing else.
#   tests/system/documents/chroot.sh tutorial|embedding|tests [DIRECTORY]
# tutorial: README's first command, then docs/use/tutorial.md in an empty directory. embedding: docs/use/embedding.md.
# tests: README's second command, with ../shared beside the clone where it stands beside this tree.
# Takes some 15 minutes, tests 25, 4 GB and a mirror; as root, with debootstrap. DIRECTORY is made and kept; without it a temporary
# one is removed at the end.
set -eu
case ${1:-} in
  tutorial)
    follow='examples/coach.sh; test -s build/coach/slalom.html
      python3 tests/system/documents/follow.py --path build/release docs/use/tutorial.md' ;;
  embedding) follow='python3 tests/system/documents/follow.py --in . docs/use/embedding.md' ;;
  tests) follow='tests/run.sh' ;;
  *) echo "usage: tests/system/documents/chroot.sh tutorial|embedding|tests [DIRECTORY]" >&2; exit 1 ;;
esac
shift
root=$(cd "$(dirname "$0")/../../.." && pwd)
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
if ! command -v debootstrap >/dev/null; then
  echo "chroot: debootstrap is missing: apt-get install debootstrap" >&2
  exit 1
fi
if [ $# -gt 0 ]; then
  debian=$1
  trap 'umount "$debian/dev/pts" "$debian/proc" 2>/dev/null || true' EXIT
else
  debian=$(mktemp -d)
  trap 'umount "$debian/dev/pts" "$debian/proc" 2>/dev/null || true; rm -rf --one-file-system "$debian"' EXIT
fi

debootstrap --variant=minbase --include=ca-certificates,git,python3-minimal,python3 bookworm "$debian" "$mirror" >"$debian.log" 2>&1 ||
  { tail "$debian.log" >&2; exit 1; }
rm -f "$debian.log"
# The same mirrors and certificates as here.
cp /etc/resolv.conf /etc/hosts "$debian/etc/"
if [ -d /etc/apt/apt.conf.d ]; then cp -r /etc/apt/apt.conf.d/. "$debian/etc/apt/apt.conf.d/"; fi
if [ -f /etc/ssl/certs/ca-certificates.crt ]; then cp /etc/ssl/certs/ca-certificates.crt "$debian/root/certificates.crt"; fi
mount -t proc proc "$debian/proc" || echo "chroot: /proc cannot be mounted, going on without"
mount -t devpts devpts "$debian/dev/pts" || echo "chroot: /dev/pts cannot be mounted, tests on terminals will fail"
git clone -q "$root" "$debian/root/mbgen"
if [ -d "$root/../shared" ]; then cp -rL "$root/../shared" "$debian/root/shared"; fi
chroot "$debian" /usr/bin/env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
  NODE_EXTRA_CA_CERTS=/root/certificates.crt \
  ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
  sh -euc "cd /root/mbgen; apt-get update -q >/dev/null; $follow"
