# shellcheck shell=bash disable=SC2034,SC2154
# Shared by tools/try_fresh and tools/try_package; sourced, not run: a bare Debian to try things on.
# The system lies in a file of limited size under ${TMPDIR:-/var/tmp} and is seen only within mount and process
# namespaces of the command: when they end nothing is mounted and the file alone has to be removed. Its /dev, /proc and
# /dev/shm are made new, and nothing of this computer's is bound into it. What apt is configured to fetch from, and
# through, here is asked of apt.
#
# The script that sources this sets `release`, `size_gb` and `logs`, has a function `bring`, which puts what is tried
# into $folder/brought, and calls start_within: it runs the script again, as `SCRIPT --within FOLDER ARGUMENTS`, inside
# of the namespaces. There make_base makes $folder/base.image, furnish makes a system of it that has /home/pxm, and
# enter runs commands in it.
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

release=bookworm
logs=
program=$(basename "$0")

need() {
    [[ $(id -u) == 0 ]] || die "needs root: it makes a file system and enters it"
    local tool
    for tool in debootstrap unshare mkfs.ext4 chroot git; do
        command -v $tool >/dev/null || die "needs $tool: install debootstrap util-linux e2fsprogs git"
    done
}

# Outside: a folder, the namespaces, and the end of it all. start_within ARGUMENTS...
start_within() {
    need
    folder=$(mktemp -d "${TMPDIR:-/var/tmp}/$program.XXXXXX")
    trap clean EXIT
    trap 'exit 130' INT TERM
    local free_gb
    free_gb=$(( $(df --output=avail -k "$folder" | tail -1) / 1024 / 1024 ))
    (( free_gb > size_gb )) || die "$folder has $free_gb GB free, $size_gb are wanted (--size)"
    mkdir "$folder/system" "$folder/log"
    bring
    unshare --mount --propagation private --pid --fork --kill-child \
        bash "$0" --within "$folder" "$@" </dev/null &
    within=$!
    local code=0
    wait $within || code=$?
    within=
    exit $code
}

# The mounts end with the namespaces; should one be left all the same, nothing below it is touched.
clean() {
    if [[ -n ${within-} ]]; then kill -KILL "$within" 2>/dev/null || true; wait "$within" 2>/dev/null || true; fi
    if [[ -n $logs && -d $folder/log ]]; then
        mkdir -p "$logs"
        find "$folder/log" -type f -exec cp -t "$logs" {} +
    fi
    ! mountpoint -q "$folder/system" || die "$folder/system is still mounted; left as it is"
    rm -rf --one-file-system -- "$folder"
}

# step WHAT COMMAND...: runs it with its output in a log; prints how long it took, how long a core worked for it, and how
# busy the computer is: seconds of a busy one are no measure.
step() {
    local what=$1 log=$folder/log/${1// /_} from=$SECONDS code=0 TIMEFORMAT='%U %S'
    shift
    { time "$@" >"$log" 2>&1 || code=$?; } 2>"$folder/core_seconds"
    printf '%-22s %5d s, %5d s of a core; load %s on %d cores\n' "$what" $(( SECONDS - from )) \
        "$(awk '{ print int($1 + $2) }' "$folder/core_seconds")" "$(cut -d' ' -f1 /proc/loadavg)" "$(nproc)"
    (( code == 0 )) || { tail -40 "$log" | sed 's/^/    /'; say "$program: $what failed with $code"; }
    return $code
}

# What apt fetches from here: SITE SUITE COMPONENT a line.
# shellcheck disable=SC2016
sources() { apt-get indextargets --format '$(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' | sort -u; }

# How apt fetches here: proxies and what it is told not to check.
transport() {
    apt-config dump | grep -E '^Acquire::(https?::)?(Proxy|Check-Valid-Until|Check-Date|Retries|Proxy-Auto-Detect)\b' || true
    local scheme variable
    for scheme in http https; do
        variable=${scheme}_proxy
        if [[ -n ${!variable-} ]]; then echo "Acquire::$scheme::Proxy \"${!variable}\";"; fi
    done
}

make_base() {
    local site sites
    sites=$(sources | awk -v r="$release" '$2 == r || index($2, r "-") == 1')
    site=$(awk -v r="$release" '$2 == r { print $1; exit }' <<<"$sites")
    [[ -n $site ]] || die "apt here knows no source of $release: apt-get update"
    truncate -s "${size_gb}G" "$folder/base.image"
    mkfs.ext4 -q -m 0 "$folder/base.image"
    mount -o loop "$folder/base.image" "$folder/system"
    local proxy
    proxy=$(transport | sed -n 's/^Acquire::http::Proxy "\(.*\)";/\1/p' | tail -1)
    step "bare $release" env ${proxy:+http_proxy="$proxy"} debootstrap --variant=minbase "$release" "$folder/system" "$site"
    awk '{ print "deb", $1, $2, $3 }' <<<"$sites" >"$folder/system/etc/apt/sources.list"
    transport >"$folder/system/etc/apt/apt.conf.d/99transport"
    umount -R "$folder/system"
}

# Devices, /proc and names of its own; what was brought.
furnish() {
    local system=$1 node
    mount -t proc proc "$system/proc"
    mount -t tmpfs -o size=1m,mode=755 tmpfs "$system/dev"
    for node in null:1:3 zero:1:5 full:1:7 random:1:8 urandom:1:9 tty:5:0; do
        IFS=: read -r name major minor <<<"$node"
        mknod -m 666 "$system/dev/$name" c "$major" "$minor"
    done
    mkdir "$system/dev/pts" "$system/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$system/dev/pts"
    mount -t tmpfs -o size=1g,mode=1777 tmpfs "$system/dev/shm"
    ln -s pts/ptmx "$system/dev/ptmx"
    ln -s /proc/self/fd "$system/dev/fd"
    for node in 0:stdin 1:stdout 2:stderr; do ln -s "/proc/self/fd/${node%:*}" "$system/dev/${node#*:}"; done
    cat /etc/resolv.conf >"$system/etc/resolv.conf"
    printf '127.0.0.1 localhost %s\n' "$(hostname)" >"$system/etc/hosts"
    mkdir -p "$system/home"
    cp -R "$folder/brought" "$system/home/pxm"
}

# enter USER COMMAND: in /home/pxm, with nothing of this computer's environment.
enter() {
    local whose=(--userspec="$1:$1")
    [[ $1 != root ]] || whose=()
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/home TERM=dumb LANG=C.UTF-8 \
        chroot "${whose[@]}" "$folder/system" bash -c "cd /home/pxm && $2"
}
