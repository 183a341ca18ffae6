/* SPDX-License-Identifier: Apache-2.0 */
#ifndef FW_STATUS_H
#define FW_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/* The one list of results: enumerators and names both come from here. */
#define FW_STATUS_LIST(X)                                                                   \
    X(FW_OK)            /* done; outputs written */                                         \
    X(FW_ERR_NULL)      /* a pointer that must be given is NULL */                          \
    X(FW_ERR_SHAPE)     /* a count outside its range, or counts that do not fit together */ \
    X(FW_ERR_CONFIG)    /* a choice that does not exist, or bins beyond the spectrum */     \
    X(FW_ERR_SCRATCH)   /* scratch too small or misaligned */                               \
    X(FW_ERR_NONFINITE) /* an infinity or NaN came in, or would go out */                   \
    X(FW_ERR_ALIGNMENT) /* bytes to be read in place do not lie at a multiple of 4 */       \
    X(FW_ERR_MAGIC)     /* the bytes are of another kind */                                 \
    X(FW_ERR_VERSION)   /* a format this library does not read */                           \
    X(FW_ERR_LENGTH)    /* fewer or more bytes than the counts in them ask for */           \
    X(FW_ERR_CHECKSUM)  /* the bytes were damaged */                                        \
    X(FW_ERR_VALUE)     /* a stored number that could make a result overflow */             \
    X(FW_ERR_CHIRP)     /* the radar runs another chirp than the model was trained on */    \
    X(FW_ERR_GEOMETRY)  /* the frame has another shape than the model was trained on */     \
    X(FW_ERR_SELF_TEST) /* this machine computes other bits than it must */                 \
    X(FW_ERR_NAME)      /* a class name that is no text, or there twice */

#define FW_STATUS_ENUMERATOR(name) name,
typedef enum fw_status { FW_STATUS_LIST(FW_STATUS_ENUMERATOR) } fw_status;
#undef FW_STATUS_ENUMERATOR

/* The enumerator as text, e.g. "FW_ERR_SHAPE"; "unknown fw_status" for any other value.
 * Never NULL; static storage. Time: constant. */
const char* fw_status_name(fw_status status);

#ifdef __cplusplus
}
#endif

#endif
