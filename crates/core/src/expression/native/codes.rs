//! The instructions of x86-64 by the registers that they work on.

use super::step::Kind;
use crate::scalar::Machine;
use iced_x86::{Code, Code::*, Register};

/// What works on one kind of register.
pub struct Codes {
    /// Bytes of a register.
    pub width: usize,
    /// Its first register, and how many there are.
    pub first: Register,
    pub count: usize,
    pub load: Code,
    pub store: Code,
    pub sqrt: Code,
    pub add: Code,
    pub sub: Code,
    pub mul: Code,
    pub div: Code,
    pub and: Code,
    pub xor: Code,
    pub compare: Code,
    pub blend: Code,
    /// Of each: ±x y ± d where the first operand is x of a second x and the third the addend, and so on: 132, 213, 231.
    pub mul_add: [Code; 3],
    pub mul_sub: [Code; 3],
    pub neg_mul_add: [Code; 3],
    /// Whether choices go by a mask register.
    pub masks: bool,
}

static ZMM: Codes = Codes {
    width: 64,
    first: Register::ZMM0,
    count: 32,
    load: EVEX_Vmovupd_zmm_k1z_zmmm512,
    store: EVEX_Vmovupd_zmmm512_k1z_zmm,
    sqrt: EVEX_Vsqrtpd_zmm_k1z_zmmm512b64_er,
    add: EVEX_Vaddpd_zmm_k1z_zmm_zmmm512b64_er,
    sub: EVEX_Vsubpd_zmm_k1z_zmm_zmmm512b64_er,
    mul: EVEX_Vmulpd_zmm_k1z_zmm_zmmm512b64_er,
    div: EVEX_Vdivpd_zmm_k1z_zmm_zmmm512b64_er,
    and: EVEX_Vandpd_zmm_k1z_zmm_zmmm512b64,
    xor: EVEX_Vxorpd_zmm_k1z_zmm_zmmm512b64,
    compare: EVEX_Vcmppd_kr_k1_zmm_zmmm512b64_imm8_sae,
    blend: EVEX_Vblendmpd_zmm_k1z_zmm_zmmm512b64,
    mul_add: [
        EVEX_Vfmadd132pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfmadd213pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfmadd231pd_zmm_k1z_zmm_zmmm512b64_er,
    ],
    mul_sub: [
        EVEX_Vfmsub132pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfmsub213pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfmsub231pd_zmm_k1z_zmm_zmmm512b64_er,
    ],
    neg_mul_add: [
        EVEX_Vfnmadd132pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfnmadd213pd_zmm_k1z_zmm_zmmm512b64_er,
        EVEX_Vfnmadd231pd_zmm_k1z_zmm_zmmm512b64_er,
    ],
    masks: true,
};

static YMM: Codes = Codes {
    width: 32,
    first: Register::YMM0,
    count: 16,
    load: VEX_Vmovupd_ymm_ymmm256,
    store: VEX_Vmovupd_ymmm256_ymm,
    sqrt: VEX_Vsqrtpd_ymm_ymmm256,
    add: VEX_Vaddpd_ymm_ymm_ymmm256,
    sub: VEX_Vsubpd_ymm_ymm_ymmm256,
    mul: VEX_Vmulpd_ymm_ymm_ymmm256,
    div: VEX_Vdivpd_ymm_ymm_ymmm256,
    and: VEX_Vandpd_ymm_ymm_ymmm256,
    xor: VEX_Vxorpd_ymm_ymm_ymmm256,
    compare: VEX_Vcmppd_ymm_ymm_ymmm256_imm8,
    blend: VEX_Vblendvpd_ymm_ymm_ymmm256_ymm,
    mul_add: [
        VEX_Vfmadd132pd_ymm_ymm_ymmm256,
        VEX_Vfmadd213pd_ymm_ymm_ymmm256,
        VEX_Vfmadd231pd_ymm_ymm_ymmm256,
    ],
    mul_sub: [
        VEX_Vfmsub132pd_ymm_ymm_ymmm256,
        VEX_Vfmsub213pd_ymm_ymm_ymmm256,
        VEX_Vfmsub231pd_ymm_ymm_ymmm256,
    ],
    neg_mul_add: [
        VEX_Vfnmadd132pd_ymm_ymm_ymmm256,
        VEX_Vfnmadd213pd_ymm_ymm_ymmm256,
        VEX_Vfnmadd231pd_ymm_ymm_ymmm256,
    ],
    masks: false,
};

static XMM: Codes = Codes {
    width: 16,
    first: Register::XMM0,
    count: 16,
    load: VEX_Vmovupd_xmm_xmmm128,
    store: VEX_Vmovupd_xmmm128_xmm,
    sqrt: VEX_Vsqrtpd_xmm_xmmm128,
    add: VEX_Vaddpd_xmm_xmm_xmmm128,
    sub: VEX_Vsubpd_xmm_xmm_xmmm128,
    mul: VEX_Vmulpd_xmm_xmm_xmmm128,
    div: VEX_Vdivpd_xmm_xmm_xmmm128,
    and: VEX_Vandpd_xmm_xmm_xmmm128,
    xor: VEX_Vxorpd_xmm_xmm_xmmm128,
    compare: VEX_Vcmppd_xmm_xmm_xmmm128_imm8,
    blend: VEX_Vblendvpd_xmm_xmm_xmmm128_xmm,
    mul_add: [
        VEX_Vfmadd132pd_xmm_xmm_xmmm128,
        VEX_Vfmadd213pd_xmm_xmm_xmmm128,
        VEX_Vfmadd231pd_xmm_xmm_xmmm128,
    ],
    mul_sub: [
        VEX_Vfmsub132pd_xmm_xmm_xmmm128,
        VEX_Vfmsub213pd_xmm_xmm_xmmm128,
        VEX_Vfmsub231pd_xmm_xmm_xmmm128,
    ],
    neg_mul_add: [
        VEX_Vfnmadd132pd_xmm_xmm_xmmm128,
        VEX_Vfnmadd213pd_xmm_xmm_xmmm128,
        VEX_Vfnmadd231pd_xmm_xmm_xmmm128,
    ],
    masks: false,
};

impl Codes {
    /// Those of a machine.
    pub fn of(machine: Machine) -> &'static Self {
        match machine {
            Machine::Zmm => &ZMM,
            Machine::Ymm => &YMM,
            Machine::Xmm => &XMM,
        }
    }

    /// The three orders of a product that is part of a sum.
    pub fn fused(&self, kind: Kind) -> [Code; 3] {
        match kind {
            Kind::MulSub => self.mul_sub,
            Kind::NegMulAdd => self.neg_mul_add,
            _ => self.mul_add,
        }
    }
}
