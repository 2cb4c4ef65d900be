/* Keeps a second copy of what a program has synced, as a disk would after the power was lost.
 *
 * Preloaded by scripts/reliability/lose-power. Whenever the program syncs a file, its content goes to
 * $SYNCED_SHADOW/<inode number>; whenever it syncs a folder, the names in it go to
 * $SYNCED_SHADOW/names, one line each: inode number, space, name. Both change in one step. A synced
 * file is held open, so that its number is not given to another file.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void put_in_place(const char* shadow, const char* name) {
  char from[4200], to[4200];
  snprintf(from, sizeof from, "%s/being-written", shadow);
  snprintf(to, sizeof to, "%s/%s", shadow, name);
  if (rename(from, to) != 0) abort();
}

static FILE* begin(const char* shadow) {
  char name[4200];
  snprintf(name, sizeof name, "%s/being-written", shadow);
  FILE* file = fopen(name, "wb");
  if (!file) abort();
  return file;
}

static void keep_content(int descriptor, unsigned long number, const char* shadow) {
  static char block[1 << 16];
  char name[32];
  FILE* copy = begin(shadow);
  off_t place = 0;
  for (ssize_t count; (count = pread(descriptor, block, sizeof block, place)) > 0; place += count) {
    if (fwrite(block, 1, (size_t)count, copy) != (size_t)count) abort();
  }
  if (fclose(copy) != 0) abort();
  snprintf(name, sizeof name, "%lu", number);
  put_in_place(shadow, name);
  if (dup(descriptor) < 0) abort(); /* never closed: see above */
}

static void keep_names(int descriptor, const char* shadow) {
  DIR* folder = fdopendir(openat(descriptor, ".", O_RDONLY | O_DIRECTORY));
  if (!folder) abort();
  FILE* list = begin(shadow);
  for (struct dirent* entry; (entry = readdir(folder));) {
    if (entry->d_type == DT_REG) fprintf(list, "%lu %s\n", entry->d_ino, entry->d_name);
  }
  closedir(folder);
  if (fclose(list) != 0) abort();
  put_in_place(shadow, "names");
}

int fsync(int descriptor) {
  static int (*real)(int);
  if (!real) real = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
  const int result = real(descriptor);
  const char* shadow = getenv("SYNCED_SHADOW");
  struct stat status;
  if (result != 0 || !shadow || fstat(descriptor, &status) != 0) return result;
  if (S_ISDIR(status.st_mode)) keep_names(descriptor, shadow);
  if (S_ISREG(status.st_mode)) keep_content(descriptor, status.st_ino, shadow);
  return result;
}

int fdatasync(int descriptor) { return fsync(descriptor); }
