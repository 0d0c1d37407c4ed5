/* Preloaded in a user namespace with one user: packages give their files to users that do not exist there. What changes owners or users does
 * nothing and succeeds. */
#include <grp.h>
#include <sys/types.h>
#include <unistd.h>

int chown(const char* path, uid_t user, gid_t group) { return (void)path, (void)user, (void)group, 0; }
int lchown(const char* path, uid_t user, gid_t group) { return (void)path, (void)user, (void)group, 0; }
int fchown(int file, uid_t user, gid_t group) { return (void)file, (void)user, (void)group, 0; }
int fchownat(int folder, const char* path, uid_t user, gid_t group, int flags) {
  return (void)folder, (void)path, (void)user, (void)group, (void)flags, 0;
}
int setgroups(size_t count, const gid_t* groups) { return (void)count, (void)groups, 0; }
int setuid(uid_t user) { return (void)user, 0; }
int setgid(gid_t group) { return (void)group, 0; }
int seteuid(uid_t user) { return (void)user, 0; }
int setegid(gid_t group) { return (void)group, 0; }
int setresuid(uid_t real, uid_t effective, uid_t saved) { return (void)real, (void)effective, (void)saved, 0; }
int setresgid(gid_t real, gid_t effective, gid_t saved) { return (void)real, (void)effective, (void)saved, 0; }
